#pragma once

#include <glm/glm.hpp>
#include <span>

#include "scene/geometry.h"

namespace enfilade {

/// Distance [m] within `plane` from the projection of `p` to the convex `polygon`; 0 inside.  Any
/// winding.
float distanceInPlane(std::span<const glm::vec3> polygon, const Plane& plane, const glm::vec3& p);

/// Distance [m] from `p` to the convex `polygon`.
float distanceToPolygon(std::span<const glm::vec3> polygon, const Plane& plane, const glm::vec3& p);

/// Whether the segment from `a` to `b` crosses the convex `polygon`, grown by `grow` [m] on every
/// side.  A segment that ends in the plane crosses; one that lies in it does not.
bool segmentCrosses(std::span<const glm::vec3> polygon, const Plane& plane, const glm::vec3& a,
                    const glm::vec3& b, float grow);

}  // namespace enfilade
