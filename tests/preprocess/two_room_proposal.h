#pragma once

#include "preprocess/cell_proposal.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Proposes TestBuilding::twoRooms() as two cells of these names: what is free to either side of
/// the wall at x = 4.  Nothing for the exterior, and no portals.
inline CellProposal twoRoomProposal(const VoxelGrid& voxels, const std::string& first,
                                    const std::string& second) {
  CellProposal proposal;
  proposal.storeys = {{"ground", 0}};
  proposal.cell_names = {"exterior", first, second};
  proposal.cell_storeys = {0, 0, 0};
  proposal.owner.assign(voxels.bits.size(), CellProposal::kNobody);
  for (std::size_t i = 0; i < voxels.bits.size(); ++i) {
    const glm::vec3 p = voxels.centerOf(voxels.voxelAt(i));
    if ((voxels.bits[i] & kVoxelSolid) || !Box{{0, 0, 0}, {8, 3, 4}}.contains(p)) continue;
    proposal.owner[i] = p.x < 4 ? 1 : 2;
  }
  return proposal;
}

}  // namespace enfilade
