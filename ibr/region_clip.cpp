#include "ibr/region_clip.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ibr/warp_window.h"

namespace enfilade {
namespace {

/// The corners of a box of (u, v, δ), in the desired picture.  Since the warp is projective, all
/// that is in the box falls into their hull, if all of them lie before the eye.
struct Corners {
  std::array<float, 8> x{}, y{}, w{};
  float least_w = 0;
  float greatest_w = 0;
};

Corners cornersOf(const SampleBox& box, const TileTransform& t) noexcept {
  Corners corners;
  for (unsigned i = 0; i < 8; ++i) {
    const float u = i & 1u ? box.greatest_u : box.least_u;
    const float v = i & 2u ? box.greatest_v : box.least_v;
    const float d = i & 4u ? box.greatest_disparity : box.least_disparity;
    const auto at = [&](int c) {
      return t.origin[c] + u * t.per_x[c] + v * t.per_y[c] + d * t.per_disparity[c];
    };
    corners.w[i] = at(2);
    corners.x[i] = at(0) / corners.w[i];
    corners.y[i] = at(1) / corners.w[i];
  }
  corners.least_w = *std::min_element(corners.w.begin(), corners.w.end());
  corners.greatest_w = *std::max_element(corners.w.begin(), corners.w.end());
  return corners;
}

/// The box around the corners; not empty.
ScreenBox boundsOf(const Corners& corners) noexcept {
  ScreenBox box{corners.x[0], corners.y[0], corners.x[0], corners.y[0]};
  for (std::size_t i = 1; i < 8; ++i) {
    box.left = std::min(box.left, corners.x[i]);
    box.right = std::max(box.right, corners.x[i]);
    box.top = std::min(box.top, corners.y[i]);
    box.bottom = std::max(box.bottom, corners.y[i]);
  }
  return box;
}

/// No splat of the box's samples reaches a pixel's centre farther from its middle than this
/// [pixels].
float reachOf(Splat splat, const SampleBox& box, const TileTransform& t, const ScreenBox& bounds,
              float least_w) noexcept {
  constexpr float kRounding = 0.05f;  // [pixels]
  constexpr float kFixed[] = {0.5f, 1.0f, 1.5f, 1.5f};
  if (splat < Splat::kSized) return kFixed[static_cast<std::size_t>(splat)] + kRounding;
  const glm::vec2 farthest(std::max(std::abs(bounds.left), std::abs(bounds.right)),
                           std::max(std::abs(bounds.top), std::abs(bounds.bottom)));
  const float half = 0.5f * box.greatest_footprint / least_w;
  const auto reach = [&](int c) {
    return half * (std::abs(t.per_x[c]) + std::abs(t.per_y[c]) +
                   farthest[c] * (std::abs(t.per_x[2]) + std::abs(t.per_y[2])));
  };
  return std::clamp(FootprintRules::kScale * std::max(reach(0), reach(1)),
                    FootprintRules::kLeastHalf, FootprintRules::kGreatestHalf) +
         kRounding;
}

}  // namespace

RegionClip::RegionClip(std::span<const glm::vec2> region, Splat splat) noexcept : splat_(splat) {
  if (region.empty()) return;
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

ScreenBox RegionClip::reached(const SampleBox& box, const TileTransform& transform) const noexcept {
  constexpr float kEverywhere = std::numeric_limits<float>::infinity();
  constexpr float kBesideTheEye = 1e-4f;
  const Corners corners = cornersOf(box, transform);
  if (corners.greatest_w <= 0.0f) return {};  // all behind the eye
  if (!(corners.least_w > kBesideTheEye * corners.greatest_w)) {
    return {-kEverywhere, -kEverywhere, kEverywhere, kEverywhere};
  }
  ScreenBox bounds = boundsOf(corners);
  const float reach = reachOf(splat_, box, transform, bounds, corners.least_w);
  for (std::size_t i = 0; i < count_; ++i) {
    const glm::vec3& edge = edges_[i];
    const float margin = edge.z + reach * (std::abs(edge.x) + std::abs(edge.y));
    float farthest_in = -kEverywhere;
    for (std::size_t c = 0; c < 8; ++c) {
      farthest_in = std::max(farthest_in, edge.x * corners.x[c] + edge.y * corners.y[c]);
    }
    if (farthest_in < -margin) return {};
  }
  bounds.left -= reach;
  bounds.right += reach;
  bounds.top -= reach;
  bounds.bottom += reach;
  return bounds;
}

}  // namespace enfilade
