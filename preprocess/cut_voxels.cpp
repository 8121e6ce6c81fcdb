#include "preprocess/cut_voxels.h"

#include "preprocess/portal_polygon.h"

namespace enfilade {

std::vector<std::uint8_t> cutVoxels(const VoxelGrid& grid, const std::vector<Portal>& portals) {
  constexpr float kGrowth = 1.0f;  // [voxels]
  std::vector<std::uint8_t> cut(grid.bits.size(), 0);
  for (const Portal& portal : portals) {
    const auto grown = growPolygon(portal.polygon, portal.plane, kGrowth * grid.voxel);
    forEachTouchedVoxel(grown, portal.plane, grid,
                        [&](const glm::ivec3& v) { cut[grid.index(v.x, v.y, v.z)] = 1; });
  }
  return cut;
}

}  // namespace enfilade
