#pragma once

#include <cstdint>
#include <vector>

namespace enfilade {

/// Squared distance [pixels²] of every pixel's centre to the nearest pixel that is not `inside`
/// (0 there); pixels beyond the border are inside.  Index x · size_z + z.  Exact.
/// Source: Felzenszwalb & Huttenlocher, Distance Transforms of Sampled Functions, 2012.
std::vector<std::int32_t> squaredDistance(const std::vector<std::uint8_t>& inside, int size_x,
                                          int size_z);

/// Where two parts of a plan became one.
struct Neck {
  std::int32_t pixel = 0;  ///< in its middle
  float half_width = 0;    ///< [pixels]
  float ratio = 0;         ///< its width by that of the narrower part
  int area = 0;            ///< [pixels] of the narrower part, as far as it is wider than the neck
};

/// Parts of a plan that necks join.
struct Basins {
  static constexpr std::int32_t kNone = -1;
  std::vector<std::int32_t> of_pixel;  ///< basin, or kNone outside
  std::vector<float> peak;             ///< [pixels] one a basin: the greatest distance in it
  std::vector<Neck> necks;             ///< that were too wide to part anything
};

/// Divides the pixels with a distance > 0 into basins: two become one if the neck between them is
/// wider than `merge_ratio` times the width of the narrower.  Basins are numbered by their first
/// pixel.
Basins watershed(const std::vector<std::int32_t>& squared_distance, int size_x, int size_z,
                 float merge_ratio);

}  // namespace enfilade
