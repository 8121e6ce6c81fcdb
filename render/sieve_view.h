#pragma once

#include <glm/glm.hpp>

#include "render/triangle_sieve_kernel.h"

namespace enfilade {

/// Where and how triangles are drawn.
struct SieveView {
  glm::mat4 clip_from_world{1};  ///< as OpenGL is given it; front faces are clockwise
  int width = 0;                 ///< of the viewport, which starts at 0, 0 [pixels]
  int height = 0;
  int sub_pixel_bits = 4;  ///< [≥ 4] of the rasteriser: GL_SUBPIXEL_BITS
};

/// The rows for what lies within |x|, |y|, |z| ≤ `reach` [m, world].
SieveRows sieveRows(const SieveView& view, const glm::vec3& reach, bool drops_counter) noexcept;

/// How the depth that OpenGL tests follows from 1 / w: z / w = constant + factor · (1 / w).
struct DepthRange {
  bool known = false;  ///< otherwise it doesn't, and nothing is to be said of what hides what
  double factor = 0;   ///< of 1 / w: negative
  double nearest = 0;  ///< 1 / w on the near plane
};

DepthRange depthRange(const glm::mat4& clip_from_world) noexcept;

/// What rounding may do to z and w of what lies within `reach`, at most.
float depthRounding(const SieveView& view, const glm::vec3& reach) noexcept;

}  // namespace enfilade
