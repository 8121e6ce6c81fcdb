#include "app/portal_size.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

glm::vec3 longestEdge(const Portal& portal) {
  glm::vec3 longest(0);
  for (std::size_t i = 0; i < portal.polygon.size(); ++i) {
    const glm::vec3 edge = portal.polygon[(i + 1) % portal.polygon.size()] - portal.polygon[i];
    if (glm::dot(edge, edge) > glm::dot(longest, longest)) longest = edge;
  }
  return glm::dot(longest, longest) > 0 ? glm::normalize(longest) : glm::vec3(1, 0, 0);
}

float extentAlong(const Portal& portal, const glm::vec3& direction) {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const glm::vec3& corner : portal.polygon) {
    low = std::min(low, glm::dot(corner, direction));
    high = std::max(high, glm::dot(corner, direction));
  }
  return portal.polygon.empty() ? 0.0f : high - low;
}

}  // namespace

bool isLevel(const Portal& portal) { return std::abs(portal.plane.normal.y) > 0.7f; }

glm::vec2 portalSize(const Portal& portal) {
  const glm::vec3 along = isLevel(portal)
                              ? longestEdge(portal)
                              : glm::normalize(glm::cross(glm::vec3(0, 1, 0), portal.plane.normal));
  const glm::vec3 across = glm::cross(portal.plane.normal, along);
  return {extentAlong(portal, along), extentAlong(portal, across)};
}

}  // namespace enfilade
