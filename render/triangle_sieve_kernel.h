#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace enfilade {

/// Triangles as structures of arrays: coordinate k of corner c is corners[3 · c + k].  Readable for
/// kSieveSlack elements past the last triangle.
using TriangleCorners = std::array<const float*, 9>;
inline constexpr std::size_t kSieveSlack = 16;

/// How triangles of one object meet the pixels of a frame.
struct SieveRows {
  glm::vec4 x;         ///< x · (p, 1) / w · (p, 1) is the window's x [pixels]
  glm::vec4 y;         ///< its y, in OpenGL's sense
  glm::vec4 w;         ///< w · (p, 1) is positive before the eye
  glm::vec2 last;      ///< the last column and row; the first are 0
  float rounding = 0;  ///< that x · (p, 1) and y · (p, 1) may be off by, and pixels by w's
  float snapping = 0;  ///< [pixels] that a rasteriser may move a corner by
  bool drops_counter = false;  ///< what is counter-clockwise in the window shows nothing
};

/// Room for what is left of some triangles, in their order, one element a triangle and kSieveSlack
/// more.
struct SieveOutput {
  std::uint32_t* triangle;  ///< its number
  /// Columns and rows whose centres it may cover.  Where a corner is at the eye's plane or behind:
  /// the whole window.
  std::int32_t *x0, *y0, *x1, *y1;
  float* nearest;  ///< the greatest 1 / w it may be drawn with; infinite if that isn't known
};

/// Keeps those of `count` triangles from `first` on that may cover a pixel's centre; what surely
/// doesn't is left out.  Returns how many it kept.
std::size_t siftTriangles(const TriangleCorners& corners, std::size_t first, std::size_t count,
                          const SieveRows& rows, const SieveOutput& out) noexcept;

}  // namespace enfilade
