#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <utility>
#include <vector>

#include "preprocess/light_points.h"

namespace enfilade {

/// The points of one object by where they are, to smooth the light between them.
class PointGrid {
 public:
  /// Keeps references to `world` and `points`.
  PointGrid(const WorldGeometry& world, const LightPoints& points, std::uint32_t object);

  /// The light at a vertex of the world: of its own point if that is of large faces, else the mean
  /// of the points about it that look its way.
  glm::vec3 lightAt(std::uint32_t vertex, const std::vector<glm::vec3>& light) const;

 private:
  std::uint64_t keyOf(const glm::ivec3& cell) const;
  glm::ivec3 cellOf(const glm::vec3& p) const;

  const WorldGeometry& world_;
  const LightPoints& points_;
  glm::vec3 origin_{0};
  std::vector<std::pair<std::uint64_t, std::uint32_t>> by_cell_;  // sorted: cell, point
};

}  // namespace enfilade
