#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// The gallery with plain colours in place of pictures, which take most of the time.
Building unpaintedGallery(std::uint64_t triangles);

/// A triangle in the world, as stored (single precision), and whose it is.
struct WorldTriangle {
  glm::vec3 a, b, c;
  std::uint32_t object;
};

/// Whether the object is a portal's or a bound's mesh, by its node's name.
bool isMarker(const Building& building, const Object& object);

/// The name of the object's uppermost node.
std::string rootName(const Building& building, const Object& object);

/// The objects' triangles in the world; of those for which `wanted(object)`.
template <class Wanted>
std::vector<WorldTriangle> worldTriangles(const Building& building, Wanted wanted) {
  std::vector<WorldTriangle> triangles;
  for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
    const Object& object = building.objects[o];
    if (!wanted(object)) continue;
    const Mesh& mesh = building.meshOf(object);
    const auto& positions = building.vertex_arrays[mesh.vertices].positions;
    const glm::mat4& m = building.worldFromObject(object);
    const auto at = [&](std::size_t i) {
      return glm::vec3(m * glm::vec4(positions[mesh.indices[i]], 1));
    };
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3)
      triangles.push_back({at(i), at(i + 1), at(i + 2), o});
  }
  return triangles;
}

/// Distance along the ray to a triangle seen from either side, or -1.
/// Source: Möller & Trumbore, Fast, Minimum Storage Ray/Triangle Intersection, 1997.
double rayMeets(const glm::dvec3& origin, const glm::dvec3& direction, const WorldTriangle& t);

/// A portal as the model states it.
struct NamedPortal {
  std::string name, room, to, kind;
  glm::vec3 corners[4];
};

std::vector<NamedPortal> namedPortals(const Building& building);

}  // namespace enfilade
