#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "preprocess/interfaces.h"
#include "preprocess/voxel_grid.h"
#include "scene/building.h"

namespace enfilade {

/// Which cells are the insides of solids (hollow walls, masonry), one flag a cell: nothing joins
/// them to the exterior, and they see hardly anything but backs of faces, or some, while the
/// building's surfaces wind about them.
/// None, if that were a good part of the building: then its walls are single sheets that face
/// outwards.  The same flags run after run.
/// Source: Jacobson, Kavan & Sorkine-Hornung, Robust Inside-Outside Segmentation using Generalized
/// Winding Numbers, 2013.
std::vector<std::uint8_t> insidesOfSolids(const Building& building,
                                          std::span<const ObjectRole> roles,
                                          const VoxelGrid& voxels,
                                          const std::vector<std::uint16_t>& owner,
                                          std::size_t cells,
                                          const std::vector<Interface>& interfaces);

}  // namespace enfilade
