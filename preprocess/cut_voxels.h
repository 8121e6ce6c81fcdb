#pragma once

#include <cstdint>
#include <vector>

#include "portals/cell_graph.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// The voxels that portals pass through, one flag a voxel: those that their polygons touch, grown
/// by a voxel so that they close against the edges of their openings.
std::vector<std::uint8_t> cutVoxels(const VoxelGrid& grid, const std::vector<Portal>& portals);

}  // namespace enfilade
