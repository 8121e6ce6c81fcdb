#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "scene/building.h"

namespace enfilade {

/// The outline of a marker mesh in the world [m], counter-clockwise as its faces are: its vertices
/// welded, the one border of its one piece walked, corners in the middle of a straight edge left
/// out.  Empty if it has no border, several, or is no manifold.
std::vector<glm::vec3> outlineOf(const Building& building, const Object& object);

}  // namespace enfilade
