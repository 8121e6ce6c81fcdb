#include "preprocess/join_panes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enfilade {

namespace {

constexpr float kAlike = 0.9f;       // cosine between the normals of panes in one plane
constexpr float kOutOfPlane = 3.1f;  // [voxels] between their planes
constexpr float kBar = 4.1f;         // [voxels] from the middle of one to the middle of the next
constexpr float kFilled = 0.45f;     // of the rectangle about them
constexpr float kReach = 0.35f;      // [m] either way, where a door or glass may stand

/// Whether a door or glass stands in or near the interface.
bool holdsNamed(const VoxelGrid& voxels, const Interface& interface) {
  const float step = 0.5f * voxels.voxel;
  for (const glm::vec3& face : interface.faces) {
    for (float n = -kReach; n <= kReach; n += step) {
      const glm::ivec3 v = voxels.voxelOf(face + interface.normal * n);
      if (voxels.contains(v) &&
          (voxels.bits[voxels.index(v.x, v.y, v.z)] & (kVoxelDoor | kVoxelGlass))) {
        return true;
      }
    }
  }
  return false;
}

bool areBeside(const Interface& a, const Interface& b, float voxel) {
  if (glm::dot(a.normal, b.normal) < kAlike) return false;
  if (std::abs(glm::dot(a.normal, b.centroid - a.centroid)) > kOutOfPlane * voxel) return false;
  const glm::vec3 gap =
      glm::max(glm::max(a.bounds.min - b.bounds.max, b.bounds.min - a.bounds.max), glm::vec3(0.0f));
  return glm::length(gap) <= kBar * voxel;
}

Interface joined(const std::vector<const Interface*>& panes) {
  Interface all = *panes.front();
  glm::dvec3 centroid(0.0), normal(0.0);
  double flat = 0;
  all.faces.clear();
  for (const Interface* pane : panes) {
    const auto count = static_cast<double>(pane->faces.size());
    all.faces.insert(all.faces.end(), pane->faces.begin(), pane->faces.end());
    all.bounds.extend(pane->bounds.min);
    all.bounds.extend(pane->bounds.max);
    centroid += count * glm::dvec3(pane->centroid);
    normal += count * glm::dvec3(pane->normal);
    flat += count * pane->planarity;
  }
  const auto count = static_cast<double>(all.faces.size());
  all.centroid = glm::vec3(centroid / count);
  all.normal = glm::vec3(glm::normalize(normal));
  all.planarity = static_cast<float>(flat / count);
  return all;
}

/// The faces' share of the rectangle about them, square to the joined normal.
float filledShare(const Interface& all, float voxel) {
  const glm::vec3& n = all.normal;
  const glm::vec3 other = std::abs(n.y) < 0.75f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 u = glm::normalize(glm::cross(other, n)), v = glm::cross(n, u);
  glm::vec2 lo(1e9f), hi(-1e9f);
  for (const glm::vec3& face : all.faces) {
    const glm::vec2 p(glm::dot(face, u), glm::dot(face, v));
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  const glm::vec2 size = hi - lo + voxel;
  // A turned plane's faces step along two axes, so that they are more than its area.
  const float steps = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  return float(all.faces.size()) * voxel * voxel / steps / (size.x * size.y);
}

}  // namespace

void joinPanes(const VoxelGrid& voxels, bool named, std::vector<Interface>& interfaces) {
  std::vector<std::size_t> group(interfaces.size());
  std::iota(group.begin(), group.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (group[i] != i) i = group[i];
    return i;
  };
  std::vector<std::uint8_t> alone(interfaces.size(), 0);
  for (std::size_t i = 0; named && i < interfaces.size(); ++i) {
    alone[i] = holdsNamed(voxels, interfaces[i]);
  }
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    for (std::size_t j = i + 1; j < interfaces.size() && interfaces[j].low == interfaces[i].low &&
                                interfaces[j].high == interfaces[i].high;
         ++j) {
      if (alone[i] || alone[j] || !areBeside(interfaces[i], interfaces[j], voxels.voxel)) continue;
      const std::size_t a = find(i), b = find(j);
      group[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<std::vector<const Interface*>> panes(interfaces.size());
  for (std::size_t i = 0; i < interfaces.size(); ++i) panes[find(i)].push_back(&interfaces[i]);
  std::vector<Interface> result;
  for (const auto& some : panes) {
    if (some.empty()) continue;
    const Interface all = joined(some);
    if (some.size() == 1 || filledShare(all, voxels.voxel) < kFilled) {
      for (const Interface* pane : some) result.push_back(*pane);
    } else {
      result.push_back(all);
    }
  }
  interfaces = std::move(result);
}

}  // namespace enfilade
