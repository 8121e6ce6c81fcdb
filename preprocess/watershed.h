#pragma once

#include <cstdint>
#include <vector>

namespace enfilade {

/// Squared distance [pixels²] of every pixel's centre to the nearest pixel that is not `inside`
/// (0 there); pixels beyond the border are inside.  Index x · size_z + z.  Exact.
/// Source: Felzenszwalb & Huttenlocher, Distance Transforms of Sampled Functions, 2012.
std::vector<std::int32_t> squaredDistance(const std::vector<std::uint8_t>& inside, int size_x,
                                          int size_z);

/// Parts of a plan that necks join.
struct Basins {
  static constexpr std::int32_t kNone = -1;
  std::vector<std::int32_t> of_pixel;  ///< basin, or kNone outside
  std::vector<float> peak;             ///< [pixels] one a basin: the greatest distance in it
};

/// Divides the pixels with a distance > 0 into basins: two become one if the neck between them is
/// wider than `merge_ratio` times the width of the narrower.  Basins are numbered by their first
/// pixel.
Basins watershed(const std::vector<std::int32_t>& squared_distance, int size_x, int size_z,
                 float merge_ratio);

}  // namespace enfilade
