#pragma once

#include <glm/glm.hpp>
#include <span>

namespace enfilade {

/// Rows [top, bottom) of a picture.
struct RowRange {
  int top = 0;
  int bottom = 0;
};

/// The pixels of a width × height picture whose centres lie in a convex polygon (in pixels, row 0
/// on top, any winding): row y holds columns [spans[y].x, spans[y].y), for the rows returned.
/// Half-open as pictures are, so that polygons that share an edge share no pixel.
/// `spans`: at least `height`; other rows are left as they are.
RowRange fillConvexPolygon(std::span<const glm::vec2> polygon, int width, int height,
                           std::span<glm::ivec2> spans) noexcept;

}  // namespace enfilade
