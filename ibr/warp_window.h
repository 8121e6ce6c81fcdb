#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace enfilade {

/// Rules of the splats that go by a sample's footprint.
struct FootprintRules {
  static constexpr float kScale = 1.1f;          ///< patches are made this much larger
  static constexpr float kLeastHalf = 0.5f;      ///< [pixels] so that none falls between centres
  static constexpr float kGreatestHalf = 16.0f;  ///< [pixels]
  static constexpr float kSameSurface = 1.03f;   ///< ratio of disparities within one surface
  static constexpr float kCrackDepth = 1.05f;    ///< ratio by which a crack's sides are nearer
  static constexpr float kLeastWeight = 1e-4f;   ///< keeps a weight above zero at the patch's edge
};

/// Pixels that may be written around the frame, so that splats need no clipping at its edge.
inline constexpr int kWindowBorder = 4;

/// The part of a working picture that a warp is to get right: columns [left, right), rows [top,
/// bottom) of the frame.  Painters may write up to 2 pixels beyond.
struct WarpWindow {
  int left = 0, top = 0, right = 0, bottom = 0;
  std::ptrdiff_t stride = 0;         ///< pixels a row of the working picture
  std::uint32_t* painted = nullptr;  ///< RGBA at the frame's pixel (0, 0); 0: nothing there
  glm::vec4* weighted = nullptr;     ///< Σ weight·(r, g, b, 1) at pixel (0, 0)
  float* nearest = nullptr;          ///< disparity of the surface nearest so far; 0: none
};

}  // namespace enfilade
