#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace enfilade {

/// Rules of the splats that go by a sample's footprint.
struct FootprintRules {
  static constexpr float kScale = 1.17f;         ///< patches are made this much larger
  static constexpr float kLeastHalf = 0.5f;      ///< [pixels] of a patch, however small it appears
  static constexpr float kGreatestHalf = 16.0f;  ///< [pixels]
  static constexpr float kSameSurface = 1.03f;   ///< ratio of disparities within one surface
  static constexpr float kCrackDepth = 1.05f;    ///< ratio by which a crack's sides are nearer
};

/// Pixels that may be written around the frame, so that splats need no clipping at its edge.
inline constexpr int kWindowBorder = 4;

/// The part of a working picture that a warp is to get right: columns [left, right), rows [top,
/// bottom) of the frame.  Painters may write up to 2 pixels beyond.
struct WarpWindow {
  int left = 0, top = 0, right = 0, bottom = 0;
  std::ptrdiff_t stride = 0;         ///< pixels a row of the working picture
  std::uint32_t* painted = nullptr;  ///< RGBA at the frame's pixel (0, 0); 0: nothing there
  std::uint64_t* sums = nullptr;     ///< Σ (r, g, b, 1) at pixel (0, 0), 16 bits each, red lowest
  float* nearest = nullptr;          ///< disparity of the surface nearest so far; 0: none
  float* closeness = nullptr;        ///< kNearest: how near the sample is to the pixel's centre
};

}  // namespace enfilade
