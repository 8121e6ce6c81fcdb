#pragma once

#include "portals/house.h"

namespace enfilade {

/// The cells and portals of a house as a building to look at in any viewer of glTF: for each cell
/// but the exterior a node of its name with the surface of its voxels, see-through and closed but
/// for edges where voxels touch, triangles counter-clockwise from outside; for each portal a node
/// of its name with its polygon, coloured by kind as in the plan, shut ones grey; and the building
/// itself left out, so that it can be laid over it.
Building cellSolids(const House& house);

}  // namespace enfilade
