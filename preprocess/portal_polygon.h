#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "preprocess/voxel_grid.h"
#include "scene/geometry.h"

namespace enfilade {

/// A planar convex polygon with every edge moved outward by `by` metres within its plane.
/// Counter-clockwise about `plane.normal`.
std::vector<glm::vec3> growPolygon(const std::vector<glm::vec3>& polygon, const Plane& plane,
                                   float by);

/// Whether a planar convex polygon and a box have a point in common.
bool polygonTouchesBox(const std::vector<glm::vec3>& polygon, const Box& box);

/// Calls `visit` for every voxel of the grid that the polygon touches (a supercover: a straight
/// line through the polygon passes at least one of them), each once, in increasing order of (x, z,
/// y).
void forEachTouchedVoxel(const std::vector<glm::vec3>& polygon, const Plane& plane,
                         const VoxelGrid& grid,
                         const std::function<void(const glm::ivec3&)>& visit);

/// Points spread evenly over a convex polygon, about `spacing` metres apart, at least one; its own
/// edges left out.
std::vector<glm::vec3> pointsWithin(const std::vector<glm::vec3>& polygon, const Plane& plane,
                                    float spacing);

}  // namespace enfilade
