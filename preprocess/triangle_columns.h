#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/glm.hpp>

namespace enfilade {

/// The voxels that a triangle touches, column by column: the thirteen separating axes of the
/// triangle–box test turned into linear bounds on y, so that a column of voxels is found at once.
/// In voxel units from the grid's origin. Source: Akenine-Möller, Fast 3D Triangle-Box Overlap
/// Testing, 2001.
class TriangleColumns {
 public:
  /// Boxes are voxels grown by `growth` voxels on every side (a small epsilon: touching counts,
  /// rounding too).
  TriangleColumns(const std::array<glm::dvec3, 3>& corners, double growth);

  /// Calls visit(x, z, y0, y1), y0 ≤ y1 inclusive, for the columns in [first, end) whose voxels the
  /// triangle touches.
  template <class Visit>
  void forEach(const glm::ivec3& first, const glm::ivec3& end, Visit&& visit) const {
    const int x0 = std::max(first.x, firstIndex(along_x_.lo));
    const int x1 = std::min(end.x - 1, lastIndex(along_x_.hi));
    const int z0 = std::max(first.z, firstIndex(along_z_.lo));
    const int z1 = std::min(end.z - 1, lastIndex(along_z_.hi));
    for (int x = x0; x <= x1; ++x) {
      for (int z = z0; z <= z1; ++z) {
        const Range range = columnRange(x + 0.5, z + 0.5);
        if (range.lo > range.hi) continue;
        const int y0 = std::max(first.y, firstIndex(range.lo));
        const int y1 = std::min(end.y - 1, lastIndex(range.hi));
        if (y0 <= y1) visit(x, z, y0, y1);
      }
    }
  }

 private:
  /// lo ≤ axis · centre ≤ hi for the centres of all boxes that this axis does not separate.
  struct AxisBounds {
    glm::dvec3 axis{0};
    double lo = 0, hi = 0;
  };
  struct Range {
    double lo = 0, hi = 0;
  };

  /// The range of voxel indices whose centres lie in [lo, hi].
  static int firstIndex(double lo) { return static_cast<int>(std::ceil(lo - 0.5)); }
  static int lastIndex(double hi) { return static_cast<int>(std::floor(hi - 0.5)); }

  AxisBounds boundsAlong(const glm::dvec3& axis) const;
  Range columnRange(double x, double z) const;  ///< the y of the touched centres; lo > hi: none

  std::array<glm::dvec3, 3> corners_;
  double half_ = 0;
  AxisBounds along_x_, along_z_;
  std::array<AxisBounds, 11> others_;  ///< every axis but the box's own x and z
};

}  // namespace enfilade
