#pragma once

#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/fit_portal.h"
#include "preprocess/interfaces.h"
#include "preprocess/room_seeds.h"

namespace enfilade {

/// Cells that are doorways, in walls so thick that each was taken for a room: nothing but the space
/// between two parallel portals less than 1.5 m apart.  Those that
/// have a name are rooms.  One flag a cell.  `fitted`: one an
/// interface.
std::vector<std::uint8_t> findPassages(const VoxelGrid& voxels,
                                       const std::vector<Interface>& interfaces,
                                       const std::vector<FittedPortal>& fitted,
                                       const CellProposal& proposal);

}  // namespace enfilade
