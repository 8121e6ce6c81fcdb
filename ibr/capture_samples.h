#pragma once

#include <cstdint>
#include <vector>

#include "ibr/depth_image.h"

namespace enfilade {

/// A patch of surface that one pixel of a capture saw, or a part of the pixel.
struct CaptureSample {
  float u = 0, v = 0;              ///< its middle, pixels of the capture
  float width = 1, height = 1;     ///< its part of the pixel, 0…1 each
  float disparity = 0;             ///< at (u, v)
  float slope_u = 0, slope_v = 0;  ///< of the disparity, per pixel, along the surface
  float doubt = 1;                 ///< [≥ 1] its patch counts as this much larger
  std::uint8_t r = 0, g = 0, b = 0;
};

/// A capture as samples, in row order; the samples of one pixel nearest first.
struct CaptureSamples {
  PlanarCamera camera;
  std::vector<CaptureSample> samples;
};

/// The surfaces seen in every block of `rays` × `rays` pixels of `fine`: one sample a surface, the
/// mean over the block's pixels that show it, so that colours are smoothed within a surface and
/// never across a silhouette.  Pixels of a block show one surface if their disparities differ from
/// the nearest one's by at most `threshold`.  Pixels where nothing is known are left out.
/// The camera is that of the blocks.  The picture's size must be a multiple of `rays`, 1…4.
CaptureSamples resolveCapture(const DepthImage& fine, int rays, float threshold);

/// The area of the surface that a sample shows [m²].
double patchArea(const PlanarCamera& camera, const CaptureSample& sample) noexcept;

}  // namespace enfilade
