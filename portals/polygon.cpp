#include "portals/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade {

namespace {

float squaredDistanceToSegment(const glm::vec3& a, const glm::vec3& b, const glm::vec3& p) {
  const glm::vec3 along = b - a;
  const float length2 = glm::dot(along, along);
  const float t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0f, 1.0f) : 0.0f;
  const glm::vec3 off = p - (a + t * along);
  return glm::dot(off, off);
}

}  // namespace

float distanceInPlane(std::span<const glm::vec3> polygon, const Plane& plane, const glm::vec3& p) {
  const glm::vec3 q = p - plane.signedDistance(p) * plane.normal;
  bool left = true;
  bool right = true;
  float nearest2 = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec3& a = polygon[i];
    const glm::vec3& b = polygon[(i + 1) % polygon.size()];
    const float side = glm::dot(glm::cross(b - a, q - a), plane.normal);
    left = left && side >= 0;
    right = right && side <= 0;
    nearest2 = std::min(nearest2, squaredDistanceToSegment(a, b, q));
  }
  return left || right ? 0.0f : std::sqrt(nearest2);
}

float distanceToPolygon(std::span<const glm::vec3> polygon, const Plane& plane,
                        const glm::vec3& p) {
  return std::hypot(plane.signedDistance(p), distanceInPlane(polygon, plane, p));
}

bool segmentCrosses(std::span<const glm::vec3> polygon, const Plane& plane, const glm::vec3& a,
                    const glm::vec3& b, float grow) {
  const float da = plane.signedDistance(a);
  const float db = plane.signedDistance(b);
  if ((da > 0 && db > 0) || (da < 0 && db < 0) || da == db) return false;
  return distanceInPlane(polygon, plane, a + (da / (da - db)) * (b - a)) <= grow;
}

std::vector<glm::vec3> grownPolygon(std::span<const glm::vec3> polygon, const Plane& plane,
                                    float by) {
  std::vector<glm::vec3> corners;  // those with an edge of some length after them
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    if (polygon[i] != polygon[(i + 1) % polygon.size()]) corners.push_back(polygon[i]);
  }
  std::vector<glm::vec3> grown = corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::size_t before = (i + corners.size() - 1) % corners.size();
    const std::size_t after = (i + 1) % corners.size();
    const auto outward = [&](const glm::vec3& edge) {
      return glm::normalize(glm::cross(edge, plane.normal));
    };
    const glm::vec3 sum =
        outward(corners[i] - corners[before]) + outward(corners[after] - corners[i]);
    // The mitre reaches `by` beyond both edges.
    grown[i] += sum * (by / std::max(0.5f * glm::dot(sum, sum), 0.125f));
  }
  return grown;
}

}  // namespace enfilade
