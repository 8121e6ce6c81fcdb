#include "preprocess/point_grid.h"

#include <algorithm>
#include <cmath>

#include "scene/geometry.h"

namespace enfilade {
namespace {

constexpr float kReach = 0.045f;  // [m] of smoothing, and the edge of a cell

}  // namespace

PointGrid::PointGrid(const WorldGeometry& world, const LightPoints& points, std::uint32_t object)
    : world_(world), points_(points) {
  const VertexRange range = verticesOf(world, object);
  const auto begin = points.of_vertex.begin() + static_cast<std::ptrdiff_t>(range.first);
  std::vector<std::uint32_t> own(begin, begin + range.count);
  std::sort(own.begin(), own.end());
  own.erase(std::unique(own.begin(), own.end()), own.end());
  Box box;
  for (const std::uint32_t p : own) box.extend(points.positions[p]);
  origin_ = box.min;
  for (const std::uint32_t p : own) {
    if (points.large[p] == 0) by_cell_.emplace_back(keyOf(cellOf(points.positions[p])), p);
  }
  std::sort(by_cell_.begin(), by_cell_.end());
}

glm::ivec3 PointGrid::cellOf(const glm::vec3& p) const {
  return glm::ivec3(glm::floor((p - origin_) / kReach)) + 1;
}

std::uint64_t PointGrid::keyOf(const glm::ivec3& cell) const {
  constexpr std::uint64_t kMask = (1u << 21) - 1;
  return (static_cast<std::uint64_t>(cell.x) & kMask) << 42 |
         (static_cast<std::uint64_t>(cell.y) & kMask) << 21 |
         (static_cast<std::uint64_t>(cell.z) & kMask);
}

glm::vec3 PointGrid::lightAt(std::uint32_t vertex, const std::vector<glm::vec3>& light) const {
  const std::uint32_t own = points_.of_vertex[vertex];
  if (points_.large[own] != 0) return light[own];
  const glm::vec3& position = world_.vertices[vertex].position;
  const glm::vec3& normal = points_.vertex_normals[vertex];
  glm::vec3 sum(0);
  float weights = 0;
  const auto add = [&](std::uint32_t p) {
    const glm::vec3 way = points_.positions[p] - position;
    const float near = 1 - glm::dot(way, way) / (kReach * kReach);
    const float alike = glm::dot(normal, points_.normals[p]);
    if (near <= 0 || alike <= 0.2f) return;
    const float weight = near * near * alike * alike;
    sum += weight * light[p];
    weights += weight;
  };
  const glm::ivec3 cell = cellOf(position);
  for (int x = -1; x <= 1; ++x) {
    for (int y = -1; y <= 1; ++y) {
      // Cells that differ in z alone follow each other.
      const std::uint64_t first = keyOf(cell + glm::ivec3(x, y, -1));
      auto at = std::lower_bound(by_cell_.begin(), by_cell_.end(), std::pair(first, 0u));
      for (; at != by_cell_.end() && at->first <= first + 2; ++at) add(at->second);
    }
  }
  return weights > 0 ? sum / weights : light[own];
}

}  // namespace enfilade
