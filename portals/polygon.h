#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

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

/// The convex `polygon` with every edge moved outward by `by` [m] ≥ 0 within its plane; acute
/// corners are drawn out by four times that at the most.  Keeps the winding; needs it to be
/// counter-clockwise about the plane's normal.
std::vector<glm::vec3> grownPolygon(std::span<const glm::vec3> polygon, const Plane& plane,
                                    float by);

}  // namespace enfilade
