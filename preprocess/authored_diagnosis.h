#pragma once

#include "preprocess/authored_names.h"
#include "preprocess/cut_cells.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Adds to the cells' log what an author would want to know: portals that join other rooms than
/// they say or face away from their room, rooms that no portal leads to or that became no cell, and
/// rooms that overlap, with how much of the smaller one's free space [m³].
void diagnoseAuthored(const AuthoredNames& names, const VoxelGrid& voxels, CutCells& cells);

}  // namespace enfilade
