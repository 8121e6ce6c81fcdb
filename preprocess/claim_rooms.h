#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/authored_names.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Makes the author's rooms cells of the proposal, the first after the exterior, in their order;
/// what no room claims stays a cell that was found.  A room claims
/// - the whole of every found room that it has at least half of, since an author's bounds are
/// rough;
/// - of one that holds half of the author's room, what lies in its bounds; if that is most of it,
///   the rest goes to whom it touches;
/// - what its bounds hold, if no room was found there;
/// - and a room without bounds (an empty node) the found room that it stands in.
/// `authored`: the author's own cells, see authoredCells().
void claimRooms(const AuthoredNames& names, const CellProposal& authored, const VoxelGrid& voxels,
                CellProposal& found);

}  // namespace enfilade
