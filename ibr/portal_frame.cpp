#include "ibr/portal_frame.h"

#include <limits>

namespace enfilade {

PortalFrame portalFrame(const Portal& portal, bool from_front) {
  PortalFrame frame;
  frame.toward = glm::normalize(glm::dvec3(portal.plane.normal)) * (from_front ? 1.0 : -1.0);
  frame.right = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), frame.toward));
  frame.up = glm::cross(frame.toward, frame.right);

  glm::dvec2 least(std::numeric_limits<double>::infinity());
  glm::dvec2 greatest = -least;
  const glm::dvec3 origin(portal.polygon.front());
  for (const glm::vec3& corner : portal.polygon) {
    const glm::dvec3 offset = glm::dvec3(corner) - origin;
    const glm::dvec2 at(glm::dot(offset, frame.right), glm::dot(offset, frame.up));
    least = glm::min(least, at);
    greatest = glm::max(greatest, at);
  }
  const glm::dvec2 middle = 0.5 * (least + greatest);
  frame.center = origin + middle.x * frame.right + middle.y * frame.up;
  frame.half_width = 0.5 * (greatest.x - least.x);
  frame.half_height = 0.5 * (greatest.y - least.y);
  return frame;
}

glm::dvec3 levelAhead(const PortalFrame& frame) {
  return glm::cross(frame.right, glm::dvec3(0, 1, 0));
}

bool standsBefore(const PortalFrame& frame, const glm::dvec3& viewpoint) {
  constexpr double kNearest = 0.05;  // [m]
  return glm::dot(viewpoint - frame.center, frame.toward) >= kNearest;
}

}  // namespace enfilade
