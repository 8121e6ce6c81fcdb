#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "render/world_geometry.h"
#include "scene/building.h"

namespace enfilade {

/// Where light is gathered: one point for the vertices of an object that are closer to each other
/// than about 3 cm and look about the same way.  Arrays have one element a point; an object's are
/// contiguous, objects in order.
struct LightPoints {
  std::vector<glm::vec3> positions;  ///< world [m], drawn 1 cm from the edges into the faces
  std::vector<glm::vec3> normals;    ///< unit
  std::vector<glm::vec3> albedos;    ///< what share of light comes back, 0…0.9
  std::vector<float> areas;          ///< [m²] of the faces about it
  std::vector<std::uint8_t> large;   ///< 1: of large triangles
  std::vector<std::uint32_t> objects;

  std::vector<std::uint32_t> of_vertex;   ///< one a vertex of the WorldGeometry: its point
  std::vector<glm::vec3> vertex_normals;  ///< one a vertex of the WorldGeometry, unit

  std::size_t size() const noexcept { return positions.size(); }
};

/// `world`: worldGeometry(building).
LightPoints makeLightPoints(const Building& building, const WorldGeometry& world);

/// For each vertex of the world that object `object` uses, from its first on, which vertex of the
/// mesh's arrays it is.
std::vector<std::uint32_t> sourceVertices(const Building& building, const WorldGeometry& world,
                                          std::uint32_t object);

/// An object's vertices in the world: the first, and how many.
struct VertexRange {
  std::uint32_t first = 0, count = 0;
};
VertexRange verticesOf(const WorldGeometry& world, std::uint32_t object);

}  // namespace enfilade
