#include "preprocess/interfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "preprocess/cell_proposal.h"

namespace enfilade {

namespace {

/// The face between `voxel` and its neighbour one further along `axis`.
struct Face {
  std::uint16_t low, high;
  glm::ivec3 voxel;
  int axis;
  bool low_first;  ///< the voxel is the low cell's
};

void addFace(const VoxelGrid& voxels, const std::vector<std::uint16_t>& owner,
             const glm::ivec3& voxel, int axis, std::vector<Face>& faces) {
  glm::ivec3 next = voxel;
  if (++next[axis] >= voxels.size[axis]) return;
  const std::uint16_t a = owner[voxels.index(voxel.x, voxel.y, voxel.z)];
  const std::uint16_t b = owner[voxels.index(next.x, next.y, next.z)];
  if (a == b || a == CellProposal::kNobody || b == CellProposal::kNobody) return;
  faces.push_back({std::min(a, b), std::max(a, b), voxel, axis, a < b});
}

/// All faces, by the pair of cells, each pair's in the grid's order.
std::vector<Face> findFaces(const VoxelGrid& voxels, const std::vector<std::uint16_t>& owner) {
  std::vector<Face> faces;
  glm::ivec3 v;
  for (v.x = 0; v.x < voxels.size.x; ++v.x) {
    for (v.z = 0; v.z < voxels.size.z; ++v.z) {
      for (v.y = 0; v.y < voxels.size.y; ++v.y) {
        for (int axis = 0; axis < 3; ++axis) addFace(voxels, owner, v, axis, faces);
      }
    }
  }
  std::stable_sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
    return std::tie(a.low, a.high) < std::tie(b.low, b.high);
  });
  return faces;
}

/// Groups the faces of one pair of cells whose voxels touch, be it at a corner: the group of each,
/// numbered by their first face.
std::vector<std::size_t> groupFaces(const VoxelGrid& voxels, const Face* faces, std::size_t count) {
  std::unordered_map<std::size_t, std::size_t> first_at;  // looked up, never walked through
  std::vector<std::size_t> parent(count);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto join = [&](std::size_t a, std::size_t b) {
    const std::size_t ra = find(a), rb = find(b);
    parent[std::max(ra, rb)] = std::min(ra, rb);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const glm::ivec3 v = faces[i].voxel;
    const auto [it, added] = first_at.emplace(voxels.index(v.x, v.y, v.z), i);
    if (!added) join(i, it->second);
    for (int n = 0; added && n < 27; ++n) {
      const glm::ivec3 w = v + glm::ivec3(n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1);
      if (!voxels.contains(w)) continue;
      const auto other = first_at.find(voxels.index(w.x, w.y, w.z));
      if (other != first_at.end()) join(i, other->second);
    }
  }
  for (std::size_t i = 0; i < count; ++i) parent[i] = find(i);
  return parent;
}

struct Sums {
  glm::dvec3 centroid{0}, normal{0};
};

void addTo(const VoxelGrid& voxels, const Face& face, Interface& interface, Sums& sums) {
  glm::vec3 half(0.0f), normal(0.0f);
  half[face.axis] = 0.5f * voxels.voxel;
  normal[face.axis] = face.low_first ? -1.0f : 1.0f;
  const glm::vec3 center = voxels.centerOf(face.voxel) + half;
  interface.low = face.low;
  interface.high = face.high;
  interface.faces.push_back(center);
  interface.bounds.extend(center);
  sums.centroid += glm::dvec3(center);
  sums.normal += glm::dvec3(normal);
}

void finish(const Sums& sums, Interface& interface) {
  const auto count = static_cast<double>(interface.faces.size());
  interface.centroid = glm::vec3(sums.centroid / count);
  const double taxicab =
      std::abs(sums.normal.x) + std::abs(sums.normal.y) + std::abs(sums.normal.z);
  interface.planarity = static_cast<float>(taxicab / count);
  interface.normal =
      taxicab > 0 ? glm::vec3(glm::normalize(sums.normal)) : glm::vec3(0.0f, 1.0f, 0.0f);
}

}  // namespace

std::vector<Interface> findInterfaces(const VoxelGrid& voxels,
                                      const std::vector<std::uint16_t>& owner) {
  const std::vector<Face> faces = findFaces(voxels, owner);
  std::vector<Interface> interfaces;
  for (std::size_t begin = 0, end = 0; begin < faces.size(); begin = end) {
    while (end < faces.size() && faces[end].low == faces[begin].low &&
           faces[end].high == faces[begin].high) {
      ++end;
    }
    const auto group = groupFaces(voxels, &faces[begin], end - begin);
    std::vector<std::size_t> place(end - begin);
    std::vector<Sums> sums;
    const std::size_t first = interfaces.size();
    for (std::size_t i = 0; i < end - begin; ++i) {
      if (group[i] == i) {
        place[i] = sums.size();
        sums.emplace_back();
        interfaces.emplace_back();
      }
      const std::size_t p = place[group[i]];
      addTo(voxels, faces[begin + i], interfaces[first + p], sums[p]);
    }
    for (std::size_t p = 0; p < sums.size(); ++p) finish(sums[p], interfaces[first + p]);
  }
  return interfaces;
}

}  // namespace enfilade
