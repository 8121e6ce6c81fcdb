#pragma once

#include <cstddef>
#include <string>

#include "scene/building.h"
#include "scene/warning_log.h"

namespace enfilade {

/// Drops the vertex arrays that no mesh indexes.
void dropUnusedVertexArrays(Building& building);

/// Moves vertices that are not finite to the origin, so that no bound of an array is spoilt; no
/// triangle may use them.
void mendPositions(Building& building);

/// No coordinate is farther from the origin [m]: areas and volumes of such numbers are finite.
inline constexpr float kFarthest = 1e12f;

/// Throws Error (kBadInput) that names `file` and a node, if a node's transform is not finite or
/// takes its mesh beyond kFarthest.
void requireWithinReach(const Building& building, const std::string& file);

/// Makes every normal a unit vector, leaving those that are.  One without a direction becomes the
/// mean of its triangles' normals, weighted by area; +Y if that has no direction either.  Returns
/// how many had none.
std::size_t mendNormals(Building& building);

/// Triangles over all meshes that have no area: they are drawn as nothing, and harm nothing.
std::size_t countWithoutArea(const Building& building);

/// Mends normals, and warns of those and of triangles without area.
void mendNormals(Building& building, WarningLog& warnings);

/// The unit vector along (b − a) × (c − a), +Y where the triangle has no area.
glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

}  // namespace enfilade
