#include "preprocess/leak.h"

#include <unordered_map>

namespace enfilade {

namespace {

/// A step of the search: the voxel, and where on its way it left the first cell.
struct Step {
  glm::ivec3 voxel, left;
};

}  // namespace

std::optional<glm::vec3> findLeak(const VoxelGrid& voxels, const std::vector<std::uint8_t>& cut,
                                  const std::vector<std::uint16_t>& owner, std::uint16_t from,
                                  std::uint16_t to) {
  const auto indexOf = [&](const glm::ivec3& v) { return voxels.index(v.x, v.y, v.z); };
  std::vector<Step> now, next;
  glm::ivec3 v;
  for (v.x = 0; v.x < voxels.size.x; ++v.x) {
    for (v.z = 0; v.z < voxels.size.z; ++v.z) {
      for (v.y = 0; v.y < voxels.size.y; ++v.y) {
        const std::size_t i = indexOf(v);
        if (owner[i] == from && !cut[i]) now.push_back({v, v});
      }
    }
  }
  std::unordered_map<std::size_t, bool> seen;  // voxels of nobody; looked up, never walked through
  std::vector<glm::vec3> middles;
  while (!now.empty() && middles.empty()) {
    next.clear();
    for (const Step& step : now) {
      for (const glm::ivec3& side : kVoxelSides) {
        const glm::ivec3 there = step.voxel + side;
        if (!voxels.contains(there)) continue;
        const std::size_t i = indexOf(there);
        if (cut[i] || (voxels.bits[i] & kVoxelSolid)) continue;
        if (owner[i] == to) {
          middles.push_back(0.5f * (voxels.centerOf(step.left) + voxels.centerOf(there)));
        } else if (owner[i] == CellProposal::kNobody && seen.emplace(i, true).second) {
          next.push_back({there, step.left});
        }
      }
    }
    std::swap(now, next);
  }
  if (middles.empty()) return std::nullopt;
  return middles[middles.size() / 2];
}

}  // namespace enfilade
