#include "preprocess/triangle_columns.h"

#include <limits>

namespace enfilade {

TriangleColumns::TriangleColumns(const std::array<glm::dvec3, 3>& corners, double growth)
    : corners_(corners), half_(0.5 + growth) {
  const auto& c = corners_;
  const std::array<glm::dvec3, 3> edges{c[1] - c[0], c[2] - c[1], c[0] - c[2]};
  along_x_ = boundsAlong({1, 0, 0});
  along_z_ = boundsAlong({0, 0, 1});
  others_[0] = boundsAlong({0, 1, 0});
  others_[1] = boundsAlong(glm::cross(edges[0], edges[1]));
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& e = edges[i];
    others_[2 + 3 * i] = boundsAlong({0, e.z, -e.y});
    others_[3 + 3 * i] = boundsAlong({-e.z, 0, e.x});
    others_[4 + 3 * i] = boundsAlong({e.y, -e.x, 0});
  }
}

TriangleColumns::AxisBounds TriangleColumns::boundsAlong(const glm::dvec3& axis) const {
  const glm::dvec3 d(glm::dot(axis, corners_[0]), glm::dot(axis, corners_[1]),
                     glm::dot(axis, corners_[2]));
  const double reach = half_ * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
  return {axis, std::min({d.x, d.y, d.z}) - reach, std::max({d.x, d.y, d.z}) + reach};
}

TriangleColumns::Range TriangleColumns::columnRange(double x, double z) const {
  Range range{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  for (const AxisBounds& b : others_) {
    const double rest = b.axis.x * x + b.axis.z * z;
    if (b.axis.y > 0) {
      range.lo = std::max(range.lo, (b.lo - rest) / b.axis.y);
      range.hi = std::min(range.hi, (b.hi - rest) / b.axis.y);
    } else if (b.axis.y < 0) {
      range.lo = std::max(range.lo, (b.hi - rest) / b.axis.y);
      range.hi = std::min(range.hi, (b.lo - rest) / b.axis.y);
    } else if (rest < b.lo || rest > b.hi) {
      return {1, 0};
    }
  }
  return range;
}

}  // namespace enfilade
