#pragma once

#include <optional>
#include <utility>

#include "preprocess/interfaces.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Parts an upright interface from the level one at its foot, if it has such: a gap in the floor
/// under a door, through which no upright plane closes it.  First the upright one, which ends at
/// its foot, then the other.
std::optional<std::pair<Interface, Interface>> splitFoot(const VoxelGrid& voxels,
                                                         const Interface& interface);

}  // namespace enfilade
