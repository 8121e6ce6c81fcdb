#include "ibr/tile_clip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ibr/reconstruction.h"

namespace enfilade {
namespace {

/// The corners of a tile's box of (u, v, δ), in the desired picture.  Since the warp is projective,
/// all that is in the box falls into their hull, if all of them lie before the eye.
struct Corners {
  std::array<glm::vec2, 8> at{};
  float least_w = 0;
  float greatest_w = 0;
};

Corners cornersOf(const LdiTile& tile, const TileTransform& t) noexcept {
  Corners corners;
  corners.least_w = std::numeric_limits<float>::infinity();
  corners.greatest_w = -corners.least_w;
  for (unsigned i = 0; i < 8; ++i) {
    const float u = i & 1u ? kLdiTile : 0.0f;
    const float v = i & 2u ? kLdiTile : 0.0f;
    const float d = i & 4u ? tile.greatest_disparity : tile.least_disparity;
    const auto at = [&](int c) {
      return t.origin[c] + u * t.per_x[c] + v * t.per_y[c] + d * t.per_disparity[c];
    };
    const float w = at(2);
    corners.least_w = std::min(corners.least_w, w);
    corners.greatest_w = std::max(corners.greatest_w, w);
    corners.at[i] = glm::vec2(at(0), at(1)) / w;
  }
  return corners;
}

/// No footprint in the tile reaches farther from its middle than this [pixels].
float reachOf(const LdiTile& tile, const TileTransform& t, const Corners& corners) noexcept {
  glm::vec2 farthest(0.0f);
  for (const glm::vec2& corner : corners.at) {
    farthest = glm::max(farthest, glm::abs(corner));
  }
  const float half = 0.5f * tile.greatest_footprint / corners.least_w;
  const auto reach = [&](int c) {
    return half * (std::abs(t.per_x[c]) + std::abs(t.per_y[c]) +
                   farthest[c] * (std::abs(t.per_x[2]) + std::abs(t.per_y[2])));
  };
  constexpr float kRounding = 0.05f;  // [pixels]
  return std::clamp(Reconstruction::kFootprintScale * std::max(reach(0), reach(1)),
                    Reconstruction::kLeastHalf, Reconstruction::kGreatestHalf) +
         kRounding;
}

}  // namespace

TileClip::TileClip(std::span<const glm::vec2> region) noexcept {
  if (region.empty()) {
    return;
  }
  glm::vec2 least = region[0];
  glm::vec2 greatest = region[0];
  float area = 0.0f;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const glm::vec2 p = region[i] - region[0];
    const glm::vec2 q = region[(i + 1) % region.size()] - region[0];
    area += p.x * q.y - p.y * q.x;
    least = glm::min(least, region[i]);
    greatest = glm::max(greatest, region[i]);
  }
  edges_[count_++] = {1, 0, -least.x};
  edges_[count_++] = {-1, 0, greatest.x};
  edges_[count_++] = {0, 1, -least.y};
  edges_[count_++] = {0, -1, greatest.y};
  for (std::size_t i = 0; i < region.size() && count_ < edges_.size(); ++i) {
    const glm::vec2 along = region[(i + 1) % region.size()] - region[i];
    const float length = glm::length(along);
    if (length > 1e-3f && area != 0.0f) {
      const glm::vec2 inward = glm::vec2(-along.y, along.x) / (area > 0.0f ? length : -length);
      edges_[count_++] = glm::vec3(inward, -glm::dot(inward, region[i]));
    }
  }
}

RowsReached TileClip::rowsReached(const LdiTile& tile,
                                  const TileTransform& transform) const noexcept {
  constexpr float kEverywhere = std::numeric_limits<float>::infinity();
  constexpr float kBesideTheEye = 1e-4f;
  const Corners corners = cornersOf(tile, transform);
  if (corners.greatest_w <= 0.0f) {
    return {};  // all behind the eye
  }
  if (!(corners.least_w > kBesideTheEye * corners.greatest_w)) {
    return {-kEverywhere, kEverywhere};
  }
  const float reach = reachOf(tile, transform, corners);
  for (std::size_t i = 0; i < count_; ++i) {
    const glm::vec3& edge = edges_[i];
    const float margin = reach * (std::abs(edge.x) + std::abs(edge.y));
    const bool outside = std::all_of(corners.at.begin(), corners.at.end(), [&](const glm::vec2& p) {
      return edge.x * p.x + edge.y * p.y + edge.z < -margin;
    });
    if (outside) {
      return {};
    }
  }
  RowsReached rows{kEverywhere, -kEverywhere};
  for (const glm::vec2& corner : corners.at) {
    rows.top = std::min(rows.top, corner.y - reach);
    rows.bottom = std::max(rows.bottom, corner.y + reach);
  }
  return rows;
}

}  // namespace enfilade
