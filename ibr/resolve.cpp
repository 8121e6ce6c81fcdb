#include "ibr/resolve.h"

#include <algorithm>
#include <cstring>

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

inline glm::vec4 normalised(const glm::vec4& weighted) noexcept { return weighted / weighted.w; }

/// A row of weighted sums, and the region's columns above and below it.
struct WeightedRow {
  const glm::vec4* weighted;
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
  /// The colour of the nearer surface in which pixel x is a crack; w = 0 if it is none.
  glm::vec4 acrossCrack(int x) const noexcept {
    glm::vec4 sum(0.0f);
    if (crackBeside(x)) sum += normalised(weighted[x - 1]) + normalised(weighted[x + 1]);
    if (crackBetween(x)) sum += normalised(weighted[x - stride]) + normalised(weighted[x + stride]);
    return sum;
  }
};

void writeColor(const glm::vec4& sum, std::uint8_t* out) noexcept {
  const glm::vec4 color = sum * (1.0f / sum.w) + 0.5f;
  for (int c = 0; c < 3; ++c) out[c] = static_cast<std::uint8_t>(static_cast<int>(color[c]));
  out[3] = 255;
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

void resolveWeighted(const RegionPart& part, const WarpWindow& window, Image& out,
                     WarpCounts& counts) noexcept {
  const auto regionAt = [&](int y) {
    return y >= part.top && y < part.bottom ? part.spans[static_cast<std::size_t>(y)]
                                            : glm::ivec2(0);
  };
  forEachRow(part, [&](int y, glm::ivec2 columns) {
    const std::ptrdiff_t at = y * window.stride;
    const WeightedRow row{window.weighted + at, window.nearest + at, window.stride,
                          regionAt(y),          regionAt(y - 1),     regionAt(y + 1)};
    std::uint8_t* pixel = pixelsOf(out, columns.x, y);
    for (int x = columns.x; x < columns.y; ++x, pixel += 4) {
      const bool covered = row.nearest[x] > 0.0f;
      const glm::vec4 crack = row.acrossCrack(x);
      if (crack.w > 0.0f) {
        writeColor(crack, pixel);
        counts.pixels_bridged += !covered;
      } else if (covered) {
        writeColor(row.weighted[x], pixel);
      } else {
        std::memset(pixel, 0, 4);
      }
      counts.pixels_uncovered += !covered;
    }
    counts.pixels += static_cast<std::size_t>(columns.y - columns.x);
  });
}

}  // namespace enfilade
