#pragma once

#include <span>
#include <vector>

#include "portals/house.h"
#include "scene/building.h"
#include "scene/geometry.h"

namespace enfilade {

/// A box in a frame of its own.
struct TurnedBox {
  glm::vec3 center{0};     ///< [m]
  glm::mat3 axes{1};       ///< columns: unit, perpendicular
  glm::vec3 lo{0}, hi{0};  ///< [m] along the axes, from the centre
};

/// The triangles that hide what is behind them (no doors, no glass), for asking which planes the
/// edges of an opening lie on.
class WallFaces {
 public:
  WallFaces(const Building& building, std::span<const ObjectRole> roles);

  struct Face {
    float offset = 0;  ///< [m] from the box's centre along the axis asked for
    float area = 0;    ///< [m²] inside the box
  };
  /// The planes perpendicular to column `axis` of `box` (to 8°) in which triangles lie inside it,
  /// by offset; those within 5 mm count as one.
  std::vector<Face> facesAcross(const TurnedBox& box, int axis) const;

  /// The angle about +Y [rad, 0…π/2) of most of the upright walls inside `box`, walls at a right
  /// angle counting alike; negative without any.
  float wallAngle(const Box& box) const;

 private:
  struct Triangle {
    glm::vec3 corners[3];
    glm::vec3 normal;  ///< unit
  };
  void collect(const Box& box, std::vector<std::uint32_t>& found) const;
  std::size_t binOf(int x, int z) const;

  std::vector<Triangle> triangles_;
  glm::vec2 origin_{0};  ///< least corner of the bins, x and z [m]
  int bins_x_ = 0, bins_z_ = 0;
  std::vector<std::vector<std::uint32_t>> bins_;
};

}  // namespace enfilade
