#include "ibr/reconstruction.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

using R = Reconstruction;

/// The pixels whose centres lie in [middle − half, middle + half), within [first, beyond).
struct Interval {
  int first, beyond;
};

/// The first pixel whose centre is at or beyond `edge` ≥ 0.
inline int firstCenterFrom(float edge) noexcept {
  const float at = edge - 0.5f;
  const int down = static_cast<int>(at);  // toward zero
  return down + (static_cast<float>(down) < at);
}

inline Interval centersWithin(float middle, float half, int first, int beyond) noexcept {
  const auto low = static_cast<float>(first);
  const auto high = static_cast<float>(beyond);
  // The comparisons' order turns not-a-number into an empty interval.
  const float from = std::min(std::max(low, middle - half), high);
  const float to = std::min(std::max(low, middle + half), high);
  return {firstCenterFrom(from), firstCenterFrom(to)};
}

/// Adds one sample to the pixels of one row.
inline void addToRow(const RegionOfBuffer& region, int y, Interval columns, float middle,
                     float per_half, float row_weight, float disparity,
                     const glm::vec3& color) noexcept {
  const std::size_t row =
      static_cast<std::size_t>(y) * static_cast<std::size_t>(region.target.color.width);
  glm::vec4* const weighted = region.target.weighted.data() + row;
  float* const nearest = region.target.nearest.data() + row;
  for (int x = columns.first; x < columns.beyond; ++x) {
    const float seen = nearest[x];
    if (disparity * R::kSameSurface < seen) {
      continue;  // hidden
    }
    const float off = 1.0f - std::abs(static_cast<float>(x) + 0.5f - middle) * per_half;
    const float weight = row_weight * (off * off + 1e-4f);
    const bool in_front = disparity > seen * R::kSameSurface;
    const glm::vec4 before = in_front ? glm::vec4(0.0f) : weighted[x];
    weighted[x] = before + weight * glm::vec4(color, 1.0f);
    nearest[x] = in_front ? disparity : seen;
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
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const float disparity = batch.disparity[i];
    const float half_height =
        std::clamp(R::kFootprintScale * batch.half_height[i], R::kLeastHalf, R::kGreatestHalf);
    const Interval rows =
        centersWithin(batch.y[i], half_height, region.rows.top, region.rows.bottom);
    if (!(disparity > 0.0f) || rows.first >= rows.beyond) {
      continue;
    }
    const float half_width =
        std::clamp(R::kFootprintScale * batch.half_width[i], R::kLeastHalf, R::kGreatestHalf);
    const float per_width = 1.0f / half_width;
    const float per_height = 1.0f / half_height;
    const glm::vec3 color(samples[i].r, samples[i].g, samples[i].b);
    for (int y = rows.first; y < rows.beyond; ++y) {
      const glm::ivec2 span = region.target.spans[static_cast<std::size_t>(y)];
      const Interval columns = centersWithin(batch.x[i], half_width, span.x, span.y);
      const float off = 1.0f - std::abs(static_cast<float>(y) + 0.5f - batch.y[i]) * per_height;
      addToRow(region, y, columns, batch.x[i], per_width, off * off + 1e-4f, disparity, color);
    }
  }
}

void resolveRegion(const RegionOfBuffer& region, WarpCounts& counts) noexcept {
  WarpBuffer& target = region.target;
  const glm::ivec2 none(0);
  for (int y = region.rows.top; y < region.rows.bottom; ++y) {
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
