#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/type_precision.hpp>
#include <span>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// A vertex as it is drawn: in the world, its tint multiplied by the sky and sun term of either
/// side.
struct WorldVertex {
  glm::vec3 position;  ///< world [m]
  glm::u8vec4 front;   ///< display colour as seen from the front; 255 is 1
  glm::u8vec4 back;    ///< as seen from behind, lit by the reversed normal
  glm::vec2 texcoord;  ///< 0 where the mesh has none
};
static_assert(sizeof(WorldVertex) == 28);

struct IndexRange {
  std::size_t first = 0;  ///< in WorldGeometry::indices
  std::uint32_t count = 0;
};

/// A building with every object's transform, normals and colours worked out once, so that all of it
/// is drawn under one matrix.  An object's vertices and indices are contiguous, objects in order;
/// front faces are counter-clockwise, mirrored objects turned round.
struct WorldGeometry {
  std::vector<WorldVertex> vertices;   ///< only those that a triangle uses
  std::vector<std::uint32_t> indices;  ///< in `vertices`; three a triangle, in the mesh's order
  std::vector<IndexRange> objects;     ///< one an object of the building
};

/// Throws Error (kMachine) when there are more vertices than 32 bits can number.
WorldGeometry worldGeometry(const Building& building);

}  // namespace enfilade
