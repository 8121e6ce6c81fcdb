#pragma once

#include <cstddef>
#include <vector>

#include "preprocess/sight_claims.h"

namespace enfilade {

/// Looks from every patch into the cells: what lies deep in a crack, or a crack itself, is met by
/// few of the lines that start in cells, but each patch here has lines of its own.  They go in
/// random directions from random points beside it, until they come out into the free space of a
/// cell; and back, so that a line between two cells may be found.
/// `lines`: about so many in all, from 4 to 64 a patch.  Returned are, for searchCracks(), those
/// that come out further than the voxels beside the patch, whose cells claim it by touch; and those
/// that follow a line out of one cell into another by no portal.  The same for any number of
/// threads.
std::vector<CrackLine> lookFromPatches(const Building& building, const Patches& patches,
                                       const RayCaster& rays, const SightClaims& sight,
                                       std::size_t lines);

}  // namespace enfilade
