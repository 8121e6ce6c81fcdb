#pragma once

#include <vector>

#include "preprocess/interfaces.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Makes one interface of those that bars part: between the same two cells, in one plane, side by
/// side with no more than three voxels between, and filling most of the rectangle about them. Those
/// in a door or glass that was `named` stay as they are: there one name is one opening.
void joinPanes(const VoxelGrid& voxels, bool named, std::vector<Interface>& interfaces);

}  // namespace enfilade
