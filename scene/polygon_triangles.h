#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace enfilade {

/// Triangles (corner indices, positive area) that fill a simple polygon of positive area; every
/// corner is one of theirs, those in a line too.  Corners may coincide, where the outline of a hole
/// is joined to the outer one.  Of a polygon that is not simple some that cover it about.
/// Source: Meisters, Polygons Have Ears, 1975.
std::vector<std::array<std::size_t, 3>> triangulate(std::span<const glm::dvec2> polygon);

/// The same of a polygon in space, flat or nearly so, either way round; they face as it does.
std::vector<std::array<std::size_t, 3>> polygonTriangles(std::span<const glm::vec3> corners);

}  // namespace enfilade
