#pragma once

#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/geometry.h"

namespace enfilade {

/// (x, y, w) in clip space from a direction in the world; its last row is the depth's direction.
inline glm::dmat3 screenFromDirection(const View& view) {
  const glm::dmat4 m(view.clip_from_world);
  return {glm::dvec3(m[0][0], m[0][1], m[0][3]), glm::dvec3(m[1][0], m[1][1], m[1][3]),
          glm::dvec3(m[2][0], m[2][1], m[2][3])};
}

/// The plane of a row of a matrix into clip space, or of a sum of such rows; its normal made unit.
inline Plane unitPlane(const glm::dvec4& row) {
  const double length = glm::length(glm::dvec3(row));
  return {glm::vec3(glm::dvec3(row) / length), static_cast<float>(row.w / length)};
}

/// The third component of a × b, b to the left of a being positive.
inline double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

}  // namespace enfilade
