#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace enfilade {

/// Triangles (indices of corners, in their order) that fill a flat simple polygon, convex or not;
/// of one that is neither flat nor simple some that cover it about.  n − 2 of n corners, fewer
/// where they lie in a line. Source: Meisters, Polygons Have Ears, 1975.
std::vector<std::array<std::size_t, 3>> polygonTriangles(std::span<const glm::vec3> corners);

}  // namespace enfilade
