#include "ibr/resolve.h"

#include <algorithm>
#include <cstring>

#include "ibr/mean_colors.h"

namespace enfilade {
namespace {

using R = FootprintRules;

/// Calls row(y, columns) for every row of the part that has columns.
template <class Row>
void forEachRow(const RegionPart& part, Row&& row) noexcept {
  for (int y = part.top; y < part.bottom; ++y) {
    const glm::ivec2 columns = part.fragment.columns(y, part.spans[static_cast<std::size_t>(y)]);
    if (columns.x < columns.y) row(y, columns);
  }
}

std::uint8_t* pixelsOf(Image& out, int x, int y) noexcept {
  return out.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(y) * out.width + x);
}

/// Whether pixels with these disparities show one surface that is nearer than `behind`.
inline bool bridges(float a, float b, float behind) noexcept {
  const float beyond = behind * R::kCrackDepth;
  return a > beyond && b > beyond && a < b * R::kCrackDepth && b < a * R::kCrackDepth;
}

/// Red, green, blue and number of samples of a pixel, divided by the number.
inline glm::vec4 meanOf(std::uint64_t sums) noexcept {
  const auto channel = [&](unsigned c) {
    return static_cast<float>(static_cast<int>(sums >> (16 * c) & 0xffffu));
  };
  return glm::vec4(channel(0), channel(1), channel(2), channel(3)) / channel(3);
}

/// A row of sums, and the region's columns on it, above and below.
struct SumsRow {
  const std::uint64_t* sums;
  const float* nearest;
  std::ptrdiff_t stride;
  glm::ivec2 region, above, below;

  static bool contains(const glm::ivec2& span, int x) noexcept { return span.x <= x && x < span.y; }

  bool crackBeside(int x) const noexcept {
    return bridges(nearest[x - 1], nearest[x + 1], nearest[x]) && x > region.x && x + 1 < region.y;
  }
  bool crackBetween(int x) const noexcept {
    return bridges(nearest[x - stride], nearest[x + stride], nearest[x]) && contains(above, x) &&
           contains(below, x);
  }
  /// The colour of the nearer surface in which pixel x is a crack; its last part is 0 if it is
  /// none.
  glm::vec4 acrossCrack(int x) const noexcept {
    glm::vec4 sum(0.0f);
    if (crackBeside(x)) sum += meanOf(sums[x - 1]) + meanOf(sums[x + 1]);
    if (crackBetween(x)) sum += meanOf(sums[x - stride]) + meanOf(sums[x + stride]);
    return sum;
  }
};

constexpr int kTogether = 32;  // pixels among which cracks are looked for at once

/// Closes the cracks among columns [x0, x1) of a row, whose first pixel is `out`; returns how many
/// of them were uncovered.
std::size_t closeCracks(const SumsRow& row, int x0, int x1, std::uint8_t* out) noexcept {
  std::size_t bridged = 0;
  for (int x = x0; x < x1; ++x, out += 4) {
    const glm::vec4 crack = row.acrossCrack(x);
    if (!(crack.w > 0.0f)) continue;
    const glm::vec4 color = crack / crack.w + 0.5f;
    for (int c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(color[c]);
    const bool uncovered = !(row.nearest[x] > 0.0f);
    out[3] = uncovered ? kAlphaOfFilling : kAlphaOfSample;
    bridged += uncovered;
  }
  return bridged;
}

}  // namespace

void resolvePainted(const RegionPart& part, const WarpWindow& window, Image& out,
                    WarpCounts& counts) noexcept {
  forEachRow(part, [&](int y, glm::ivec2 columns) {
    const std::uint32_t* const from = window.painted + y * window.stride + columns.x;
    const auto count = static_cast<std::size_t>(columns.y - columns.x);
    std::memcpy(pixelsOf(out, columns.x, y), from, 4 * count);
    counts.pixels += count;
    counts.pixels_uncovered += static_cast<std::size_t>(std::count(from, from + count, 0u));
  });
}

void resolveMeans(const RegionPart& part, const WarpWindow& window, Image& out,
                  WarpCounts& counts) noexcept {
  const auto regionAt = [&](int y) {
    return y >= part.top && y < part.bottom ? part.spans[static_cast<std::size_t>(y)]
                                            : glm::ivec2(0);
  };
  forEachRow(part, [&](int y, glm::ivec2 columns) {
    const std::ptrdiff_t at = y * window.stride;
    const SumsRow row{window.sums + at, window.nearest + at, window.stride,
                      regionAt(y),      regionAt(y - 1),     regionAt(y + 1)};
    std::uint8_t* const pixels = pixelsOf(out, columns.x, y);
    const auto count = static_cast<std::size_t>(columns.y - columns.x);
    counts.pixels += count;
    counts.pixels_uncovered += meanColors(row.sums + columns.x, count, pixels);
    for (int x = columns.x; x < columns.y; x += kTogether) {
      const int beyond = std::min(x + kTogether, columns.y);
      if (mayHoldCracks(row.nearest + x, row.stride, static_cast<std::size_t>(beyond - x),
                        R::kCrackDepth)) {
        counts.pixels_bridged += closeCracks(row, x, beyond, pixels + 4 * (x - columns.x));
      }
    }
  });
}

}  // namespace enfilade
