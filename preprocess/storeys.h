#pragma once

#include <vector>

#include "preprocess/voxel_grid.h"

namespace enfilade {

/// A storey in the grid: its voxels are those from its floor to the next storey's.
struct StoreyBand {
  int floor = 0;    ///< [voxel] the floor's own voxel, solid
  int begin_y = 0;  ///< [voxel] first of the band; 0 for the lowest
  int end_y = 0;    ///< [voxel] one past the last; the grid's height for the highest
};

/// The storeys, lowest first, at least one: peaks in the area of floors that have headroom and are
/// roofed over; or shut in by walls, where hardly anything is; or any, where nothing else is.
std::vector<StoreyBand> findStoreys(const VoxelGrid& voxels);

}  // namespace enfilade
