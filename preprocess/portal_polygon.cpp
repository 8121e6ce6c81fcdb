#include "preprocess/portal_polygon.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

std::vector<glm::vec3> growPolygon(const std::vector<glm::vec3>& polygon, const Plane& plane,
                                   float by) {
  const std::size_t n = polygon.size();
  std::vector<glm::vec3> outward(n);
  for (std::size_t i = 0; i < n; ++i) {
    outward[i] = glm::normalize(glm::cross(polygon[(i + 1) % n] - polygon[i], plane.normal));
  }
  std::vector<glm::vec3> grown(n);
  for (std::size_t i = 0; i < n; ++i) {
    const glm::vec3& before = outward[(i + n - 1) % n];
    // The corner of the two moved edges; a very sharp corner is cut off rather than drawn out.
    const float spread = std::max(1.0f + glm::dot(before, outward[i]), 0.25f);
    grown[i] = polygon[i] + (before + outward[i]) * (by / spread);
  }
  return grown;
}

bool polygonTouchesBox(const std::vector<glm::vec3>& polygon, const Box& box) {
  std::vector<glm::vec3> part = polygon;
  std::vector<glm::vec3> next;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {1.0f, -1.0f}) {
      const float limit = sign > 0 ? box.max[axis] : -box.min[axis];
      next.clear();
      for (std::size_t i = 0; i < part.size(); ++i) {
        const glm::vec3& a = part[i];
        const glm::vec3& b = part[(i + 1) % part.size()];
        const float da = limit - sign * a[axis];
        const float db = limit - sign * b[axis];
        if (da >= 0) next.push_back(a);
        if ((da >= 0) != (db >= 0)) next.push_back(a + (b - a) * (da / (da - db)));
      }
      part.swap(next);
      if (part.empty()) return false;
    }
  }
  return true;
}

void forEachTouchedVoxel(const std::vector<glm::vec3>& polygon, const Plane& plane,
                         const VoxelGrid& grid,
                         const std::function<void(const glm::ivec3&)>& visit) {
  Box bounds;
  for (const glm::vec3& corner : polygon) bounds.extend(corner);
  const float epsilon = 1e-3f * grid.voxel;  // voxels that the polygon only grazes count
  const glm::ivec3 first = glm::max(grid.voxelOf(bounds.min - epsilon), glm::ivec3(0));
  const glm::ivec3 last = glm::min(grid.voxelOf(bounds.max + epsilon), grid.size - 1);
  const float half = 0.5f * grid.voxel + epsilon;
  const glm::vec3 n = glm::abs(plane.normal);
  const float reach = half * (n.x + n.y + n.z);
  for (int x = first.x; x <= last.x; ++x) {
    for (int z = first.z; z <= last.z; ++z) {
      for (int y = first.y; y <= last.y; ++y) {
        const glm::vec3 center = grid.centerOf({x, y, z});
        if (std::abs(plane.signedDistance(center)) > reach) continue;
        if (polygonTouchesBox(polygon, Box{center, center}.grown(half))) visit({x, y, z});
      }
    }
  }
}

namespace {

bool insideConvex(const std::vector<glm::vec3>& polygon, const Plane& plane, const glm::vec3& p) {
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec3& a = polygon[i];
    const glm::vec3& b = polygon[(i + 1) % polygon.size()];
    if (glm::dot(glm::cross(b - a, p - a), plane.normal) <= 0) return false;
  }
  return true;
}

}  // namespace

std::vector<glm::vec3> pointsWithin(const std::vector<glm::vec3>& polygon, const Plane& plane,
                                    float spacing) {
  glm::vec3 center(0);
  for (const glm::vec3& corner : polygon) center += corner / static_cast<float>(polygon.size());
  const glm::vec3 u = glm::normalize(polygon[1] - polygon[0]);
  const glm::vec3 v = glm::cross(plane.normal, u);
  glm::vec2 least(0), most(0);
  for (const glm::vec3& corner : polygon) {
    const glm::vec2 at(glm::dot(corner - center, u), glm::dot(corner - center, v));
    least = glm::min(least, at);
    most = glm::max(most, at);
  }
  const glm::vec2 size = most - least;
  const glm::ivec2 count = glm::max(glm::ivec2(glm::ceil(size / spacing)), glm::ivec2(1));
  std::vector<glm::vec3> points;
  for (int i = 0; i < count.x; ++i) {
    for (int j = 0; j < count.y; ++j) {
      const glm::vec2 at = least + size * (glm::vec2(i, j) + 0.5f) / glm::vec2(count);
      const glm::vec3 p = center + u * at.x + v * at.y;
      if (insideConvex(polygon, plane, p)) points.push_back(p);
    }
  }
  if (points.empty()) points.push_back(center);
  return points;
}

}  // namespace enfilade
