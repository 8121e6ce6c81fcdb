#include "preprocess/grow_cells.h"

#include <algorithm>

namespace enfilade {

namespace {

struct Grower {
  const VoxelGrid& voxels;
  const std::vector<SeedRange>& ranges;
  std::vector<std::uint16_t>& owner;

  std::size_t index(const glm::ivec3& v) const { return voxels.index(v.x, v.y, v.z); }

  /// Outside the grid is free.
  bool free(const glm::ivec3& v) const {
    return !voxels.contains(v) || !(voxels.bits[index(v)] & kVoxelSolid);
  }
  bool crossFits(const glm::ivec3& v) const {
    if (!free(v)) return false;
    for (const glm::ivec3& side : kVoxelSides) {
      if (!free(v + side)) return false;
    }
    return true;
  }
  /// Whether `v` lies in a cross of free voxels.
  bool roomy(const glm::ivec3& v) const {
    if (crossFits(v)) return true;
    for (const glm::ivec3& side : kVoxelSides) {
      if (crossFits(v + side)) return true;
    }
    return false;
  }
  bool unowned(const glm::ivec3& v) const {
    return voxels.contains(v) && owner[index(v)] == CellProposal::kNobody &&
           !(voxels.bits[index(v)] & kVoxelSolid);
  }

  /// Owned voxels with a free neighbour that nobody owns, in the grid's order.
  std::vector<glm::ivec3> front() const {
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < owner.size(); ++i) {
      if (owner[i] != CellProposal::kNobody || (voxels.bits[i] & kVoxelSolid)) continue;
      const glm::ivec3 v = voxels.voxelAt(i);
      for (const glm::ivec3& side : kVoxelSides) {
        const glm::ivec3 other = v + side;
        if (voxels.contains(other) && owner[index(other)] != CellProposal::kNobody) {
          found.push_back(index(other));
        }
      }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    std::vector<glm::ivec3> result;
    for (const std::size_t i : found) result.push_back(voxels.voxelAt(i));
    return result;
  }

  void grow(bool only_roomy, bool in_range) {
    std::vector<glm::ivec3> now = front(), next;
    while (!now.empty()) {
      next.clear();
      for (const glm::ivec3& v : now) {
        for (const glm::ivec3& side : kVoxelSides) {
          const glm::ivec3 to = v + side;
          const std::uint16_t cell = owner[index(v)];
          if (!unowned(to) || (only_roomy && !roomy(to))) continue;
          if (in_range && (to.y < ranges[cell].begin_y || to.y >= ranges[cell].end_y)) continue;
          owner[index(to)] = cell;
          next.push_back(to);
        }
      }
      std::swap(now, next);
    }
  }
};

}  // namespace

void growCells(const VoxelGrid& voxels, RoomSeeds& seeds) {
  Grower grower{voxels, seeds.ranges, seeds.owner};
  grower.grow(true, true);
  grower.grow(true, false);
  grower.grow(false, false);
}

}  // namespace enfilade
