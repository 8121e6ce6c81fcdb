#include "app/walk_barriers.h"

#include <algorithm>
#include <cmath>

#include "portals/open_doors.h"

namespace enfilade {

namespace {

float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }

bool finite(const glm::vec3& p) { return std::isfinite(p.x + p.y + p.z); }

// Andrew's monotone chain.
std::vector<glm::vec2> convexHull(std::vector<glm::vec2> points) {
  const auto less = [](const glm::vec2& a, const glm::vec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<glm::vec2> hull;
  const auto append = [&](const glm::vec2& p, std::size_t keep) {
    while (hull.size() > keep && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0) {
      hull.pop_back();
    }
    hull.push_back(p);
  };
  for (const glm::vec2& p : points) append(p, 1);
  const std::size_t lower = hull.size();
  for (std::size_t i = points.size() - 1; i-- > 0;) append(points[i], lower);
  hull.pop_back();
  return hull;
}

std::vector<glm::vec3> cornersOf(const Building& building, std::uint32_t object) {
  const Mesh& mesh = building.meshOf(building.objects[object]);
  const glm::mat4& world = building.worldFromObject(building.objects[object]);
  std::vector<glm::vec3> corners;
  for (const std::uint32_t i : mesh.indices) {
    const glm::vec3& p = building.vertex_arrays[mesh.vertices].positions[i];
    corners.emplace_back(world * glm::vec4(p, 1.0f));
  }
  return corners;
}

WalkBarrier barrierAround(const std::vector<glm::vec3>& corners) {
  WalkBarrier barrier;
  Box box;
  std::vector<glm::vec2> plan;
  for (const glm::vec3& p : corners) {
    if (!finite(p)) continue;
    box.extend(p);
    plan.emplace_back(p.x, p.z);
  }
  if (box.empty()) return barrier;
  barrier.outline = convexHull(std::move(plan));
  barrier.least = {box.min.x, box.min.z};
  barrier.most = {box.max.x, box.max.z};
  barrier.bottom = box.min.y;
  barrier.top = box.max.y;
  return barrier;
}

}  // namespace

float WalkBarrier::distance(const glm::vec2& p, float far) const noexcept {
  const glm::vec2 beyond = glm::max(glm::max(least - p, p - most), glm::vec2(0));
  if (outline.empty() || glm::length(beyond) >= far) return far;
  float squared = std::numeric_limits<float>::infinity();
  bool inside = outline.size() > 2;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::vec2& a = outline[i];
    const glm::vec2 side = outline[(i + 1) % outline.size()] - a;
    const float length = glm::dot(side, side);
    const float t = length > 0 ? std::clamp(glm::dot(p - a, side) / length, 0.0f, 1.0f) : 0.0f;
    const glm::vec2 gap = p - (a + t * side);
    squared = std::min(squared, glm::dot(gap, gap));
    inside = inside && cross(side, p - a) >= 0;
  }
  return inside ? -std::sqrt(squared) : std::sqrt(squared);
}

std::vector<WalkBarrier> walkBarriers(const House& house) {
  std::vector<std::vector<glm::vec3>> corners;
  for (const Portal& portal : house.graph.portals) corners.push_back(portal.polygon);
  for (const DoorLeaf& leaf : doorLeaves(house)) {
    const std::vector<glm::vec3> more = cornersOf(house.building, leaf.object);
    corners[leaf.portal].insert(corners[leaf.portal].end(), more.begin(), more.end());
  }
  std::vector<WalkBarrier> barriers;
  for (const std::vector<glm::vec3>& c : corners) barriers.push_back(barrierAround(c));
  return barriers;
}

}  // namespace enfilade
