#include "ibr/convex_region.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade {
namespace {

/// The first pixel whose centre is at or beyond `edge`, within 0…size; 0 for not-a-number.
int firstCenterFrom(double edge, int size) {
  const double first = std::ceil(edge - 0.5);
  return first > 0.0 ? static_cast<int>(std::min(first, static_cast<double>(size))) : 0;
}

}  // namespace

RowRange fillConvexPolygon(std::span<const glm::vec2> polygon, int width, int height,
                           std::span<glm::ivec2> spans) noexcept {
  if (polygon.size() < 3) {
    return {};
  }
  float least = polygon[0].y;
  float greatest = polygon[0].y;
  for (const glm::vec2& corner : polygon) {
    least = std::min(least, corner.y);
    greatest = std::max(greatest, corner.y);
  }
  const RowRange rows{firstCenterFrom(static_cast<double>(least), height),
                      firstCenterFrom(static_cast<double>(greatest), height)};
  for (int y = rows.top; y < rows.bottom; ++y) {
    const double center = y + 0.5;
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const glm::dvec2 p(polygon[i]);
      const glm::dvec2 q(polygon[(i + 1) % polygon.size()]);
      if ((p.y <= center) != (q.y <= center)) {
        const double x = p.x + (center - p.y) / (q.y - p.y) * (q.x - p.x);
        left = std::min(left, x);
        right = std::max(right, x);
      }
    }
    const int begin = firstCenterFrom(left, width);
    spans[static_cast<std::size_t>(y)] = {begin, std::max(begin, firstCenterFrom(right, width))};
  }
  return {rows.top, std::max(rows.top, rows.bottom)};
}

}  // namespace enfilade
