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

/// The owners of a column of voxels, and of those one further along x and z: null past the grid.
struct OwnerColumns {
  const std::uint16_t* here;
  const std::uint16_t* next_x;
  const std::uint16_t* next_z;
};

void addFace(std::uint16_t a, std::uint16_t b, const glm::ivec3& voxel, int axis,
             std::vector<Face>& faces) {
  if (a == b || a == CellProposal::kNobody || b == CellProposal::kNobody) return;
  faces.push_back({std::min(a, b), std::max(a, b), voxel, axis, a < b});
}

/// The faces of the column of `height` voxels at x, z; most voxels have neighbours like them.
void addFacesOfColumn(const OwnerColumns& owners, int x, int z, int height,
                      std::vector<Face>& faces) {
  for (int y = 0; y < height; ++y) {
    const std::uint16_t own = owners.here[y];
    const glm::ivec3 voxel(x, y, z);
    if (owners.next_x != nullptr) addFace(own, owners.next_x[y], voxel, 0, faces);
    if (y + 1 < height) addFace(own, owners.here[y + 1], voxel, 1, faces);
    if (owners.next_z != nullptr) addFace(own, owners.next_z[y], voxel, 2, faces);
  }
}

/// All faces, by the pair of cells, each pair's in the grid's order.
std::vector<Face> findFaces(const VoxelGrid& voxels, const std::vector<std::uint16_t>& owner) {
  std::vector<Face> faces;
  const auto column = [&](int x, int z) -> const std::uint16_t* {
    if (x >= voxels.size.x || z >= voxels.size.z) return nullptr;
    return &owner[voxels.index(x, 0, z)];
  };
  for (int x = 0; x < voxels.size.x; ++x) {
    for (int z = 0; z < voxels.size.z; ++z) {
      addFacesOfColumn({column(x, z), column(x + 1, z), column(x, z + 1)}, x, z, voxels.size.y,
                       faces);
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
