#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ibr/planar_camera.h"

namespace enfilade {

/// One sample of a layered depth image: 8 bytes.
struct LdiSample {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  std::uint32_t depth =
      0;  ///< disparity and sub-pixel offset, packed: see disparityOf() and packDepth()
};
static_assert(sizeof(LdiSample) == 8);

/// A layered depth image: several samples a pixel, along the rays of one planar camera.
/// Pixels in row order, samples of a pixel by decreasing disparity (nearest first).
/// Source: Shade, Gortler, He & Szeliski, Layered Depth Images, 1998; Rafferty et al. 1998,
/// sec. 3.2.
struct Ldi {
  PlanarCamera camera;
  std::vector<std::uint32_t>
      first;  ///< width · height + 1: a pixel's samples are [first[i], first[i + 1])
  std::vector<LdiSample> samples;

  std::span<const LdiSample> at(int x, int y) const;
};

}  // namespace enfilade
