#pragma once

#include "preprocess/fit_portal.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// What a portal is: a door if a named door stands in it or if it reaches from the floor to a
/// lintel, a window if glass stands in it or if it leads outdoors above a sill, otherwise an
/// opening.  Horizontal ones are openings, or windows.
PortalKind kindOf(const VoxelGrid& voxels, const FittedPortal& portal, bool to_exterior);

}  // namespace enfilade
