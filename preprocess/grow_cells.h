#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/room_seeds.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Grows every seed at the same speed through free voxels that nobody owns, so that fronts meet in
/// the middle of passages: first where there is room for a 3-voxel cross, each within its own
/// storeys, so that stairs and voids part at the floor's plane; then anywhere; last into cracks and
/// hollow walls.  What cannot be reached stays CellProposal::kNobody.
void growCells(const VoxelGrid& voxels, RoomSeeds& seeds);

}  // namespace enfilade
