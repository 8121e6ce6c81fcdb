#include "ibr/reconstruction.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace enfilade {
namespace {

using R = Reconstruction;

/// Keeps a sample's weight above zero at the edge of its footprint.
constexpr float kLeastWeight = 1e-4f;

/// Four floats that are added and multiplied at once.
using Float4 = float __attribute__((vector_size(16)));

inline Float4 load(const glm::vec4& v) noexcept { return Float4{v.x, v.y, v.z, v.w}; }
inline void store(Float4 v, glm::vec4& to) noexcept { std::memcpy(&to, &v, sizeof(v)); }

/// The pixels that a batch of samples covers: columns [x0, x1), rows [y0, y1), and how fast its
/// weights fall off.
struct Coverage {
  alignas(64) int x0[kWarpBatch], x1[kWarpBatch], y0[kWarpBatch], y1[kWarpBatch];
  alignas(64) float per_half_width[kWarpBatch], per_half_height[kWarpBatch];
};

/// The first pixel within [first, beyond] ≥ 0 whose centre is at or beyond `edge`.  The order of
/// the comparisons turns not-a-number into `first`.
inline int firstCenterFrom(float edge, float first, float beyond) noexcept {
  const float at = std::min(std::max(first, edge), beyond) - 0.5f;
  const int down = static_cast<int>(at);  // toward zero
  return down + (static_cast<float>(down) < at ? 1 : 0);
}

/// Which pixels within columns and rows [least, beyond) the samples' footprints cover.
void cover(const WarpedBatch& batch, std::size_t count, const glm::vec2& least,
           const glm::vec2& beyond, Coverage& out) noexcept {
  const auto footprint = [](float half) {
    return std::min(std::max(R::kLeastHalf, R::kFootprintScale * half), R::kGreatestHalf);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const float half_width = footprint(batch.half_width[i]);
    const float half_height = footprint(batch.half_height[i]);
    out.per_half_width[i] = 1.0f / half_width;
    out.per_half_height[i] = 1.0f / half_height;
    out.x0[i] = firstCenterFrom(batch.x[i] - half_width, least.x, beyond.x);
    out.x1[i] = firstCenterFrom(batch.x[i] + half_width, least.x, beyond.x);
    out.y0[i] = firstCenterFrom(batch.y[i] - half_height, least.y, beyond.y);
    const int y1 = firstCenterFrom(batch.y[i] + half_height, least.y, beyond.y);
    out.y1[i] = batch.disparity[i] > 0.0f ? y1 : 0;  // none behind the eye
  }
}

/// One sample on its way into a row of pixels.
struct RowSample {
  Float4 color;  ///< red, green, blue, 1
  float x, per_half_width, row_weight, disparity;
};

/// Adds a sample to columns [x0, x1) of a row.
inline void addToRow(const RowSample& s, int x0, int x1, glm::vec4* weighted,
                     float* nearest) noexcept {
  for (int x = x0; x < x1; ++x) {
    const float seen = nearest[x];
    if (s.disparity * R::kSameSurface < seen) {
      continue;  // hidden
    }
    const float off = 1.0f - std::abs(static_cast<float>(x) + 0.5f - s.x) * s.per_half_width;
    const Float4 added = s.row_weight * (off * off + kLeastWeight) * s.color;
    if (s.disparity > seen * R::kSameSurface) {  // in front
      nearest[x] = s.disparity;
      store(added, weighted[x]);
    } else {
      store(load(weighted[x]) + added, weighted[x]);
    }
  }
}

/// Whether pixels with these disparities show one surface that is nearer than `behind`.
inline bool bridges(float a, float b, float behind) noexcept {
  const float beyond = behind * R::kCrackDepth;
  return a > beyond && b > beyond && a < b * R::kCrackDepth && b < a * R::kCrackDepth;
}

inline glm::vec4 normalised(const glm::vec4& weighted) noexcept { return weighted / weighted.w; }

/// The colour of the nearer surface in which pixel p is a crack; w = 0 if it is none.
inline glm::vec4 acrossCrack(const WarpBuffer& target, std::size_t p, bool beside, bool between) {
  const auto width = static_cast<std::size_t>(target.color.width);
  const float* const nearest = target.nearest.data();
  glm::vec4 sum(0.0f);
  if (beside && bridges(nearest[p - 1], nearest[p + 1], nearest[p])) {
    sum += normalised(target.weighted[p - 1]) + normalised(target.weighted[p + 1]);
  }
  if (between && bridges(nearest[p - width], nearest[p + width], nearest[p])) {
    sum += normalised(target.weighted[p - width]) + normalised(target.weighted[p + width]);
  }
  return sum;
}

inline bool contains(const glm::ivec2& span, int x) noexcept { return span.x <= x && x < span.y; }

}  // namespace

RegionOfBuffer regionOf(std::span<const glm::vec2> polygon, WarpBuffer& target) noexcept {
  const int width = target.color.width;
  RegionOfBuffer region{
      target, fillConvexPolygon(polygon, width, target.color.height, target.spans), width, 0};
  for (int y = region.rows.top; y < region.rows.bottom; ++y) {
    const glm::ivec2 span = target.spans[static_cast<std::size_t>(y)];
    region.left = std::min(region.left, span.x);
    region.right = std::max(region.right, span.y);
  }
  region.left = std::min(region.left, region.right);
  return region;
}

void clearRegion(const RegionOfBuffer& region) noexcept {
  WarpBuffer& target = region.target;
  for (int y = region.rows.top; y < region.rows.bottom; ++y) {
    const glm::ivec2 span = target.spans[static_cast<std::size_t>(y)];
    const auto row = static_cast<std::ptrdiff_t>(y) * target.color.width;
    std::fill(target.weighted.begin() + row + span.x, target.weighted.begin() + row + span.y,
              glm::vec4(0.0f));
    std::fill(target.nearest.begin() + row + span.x, target.nearest.begin() + row + span.y, 0.0f);
  }
}

void addSamples(const RegionOfBuffer& region, const WarpedBatch& batch,
                std::span<const LdiSample> samples) noexcept {
  Coverage covers;
  cover(batch, samples.size(), {region.left, region.rows.top}, {region.right, region.rows.bottom},
        covers);
  const std::ptrdiff_t width = region.target.color.width;
  glm::vec4* const weighted = region.target.weighted.data();
  float* const nearest = region.target.nearest.data();
  const glm::ivec2* const spans = region.target.spans.data();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const int x0 = covers.x0[i];
    const int x1 = covers.x1[i];
    const int y1 = covers.y1[i];
    if (x0 >= x1 || covers.y0[i] >= y1) {
      continue;
    }
    RowSample row{{static_cast<float>(int{samples[i].r}), static_cast<float>(int{samples[i].g}),
                   static_cast<float>(int{samples[i].b}), 1.0f},
                  batch.x[i],
                  covers.per_half_width[i],
                  0.0f,
                  batch.disparity[i]};
    for (int y = covers.y0[i]; y < y1; ++y) {
      const float off =
          1.0f - std::abs(static_cast<float>(y) + 0.5f - batch.y[i]) * covers.per_half_height[i];
      row.row_weight = off * off + kLeastWeight;
      addToRow(row, std::max(x0, spans[y].x), std::min(x1, spans[y].y), weighted + y * width,
               nearest + y * width);
    }
  }
}

void resolveRegion(const RegionOfBuffer& region, RowRange rows, WarpCounts& counts) noexcept {
  WarpBuffer& target = region.target;
  const glm::ivec2 none(0);
  for (int y = rows.top; y < rows.bottom; ++y) {
    const glm::ivec2 span = target.spans[static_cast<std::size_t>(y)];
    const glm::ivec2 above =
        y > region.rows.top ? target.spans[static_cast<std::size_t>(y - 1)] : none;
    const glm::ivec2 below =
        y + 1 < region.rows.bottom ? target.spans[static_cast<std::size_t>(y + 1)] : none;
    for (int x = span.x; x < span.y; ++x) {
      const std::size_t p =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(target.color.width) +
          static_cast<std::size_t>(x);
      const bool covered = target.nearest[p] > 0.0f;
      const glm::vec4 crack = acrossCrack(target, p, x > span.x && x + 1 < span.y,
                                          contains(above, x) && contains(below, x));
      const bool bridged = crack.w > 0.0f;
      const glm::vec4 sum = bridged ? crack : target.weighted[p];
      const float scale = covered || bridged ? 1.0f / sum.w : 0.0f;
      std::uint8_t* const out = &target.color.rgba[4 * p];
      for (int c = 0; c < 3; ++c) {
        out[c] = static_cast<std::uint8_t>(sum[c] * scale + 0.5f);
      }
      out[3] = covered || bridged ? 255 : 0;
      ++counts.pixels;
      counts.pixels_uncovered += !covered;
      counts.pixels_bridged += !covered && bridged;
    }
  }
}

}  // namespace enfilade
