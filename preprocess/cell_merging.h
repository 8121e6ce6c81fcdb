#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/interfaces.h"

namespace enfilade {

/// Numbers the cells that are left, and their voxels.  `into` has one entry a cell: itself, a cell
/// before it that it becomes part of, or CellProposal::kNobody to give it up.
void mergeCells(const std::vector<std::uint16_t>& into, CellProposal& proposal);

/// Gives up cells that nothing joins to the exterior or to any wide enough to be a room: the
/// insides of thick walls and shafts.  `widths` [m], one a cell.  Returns how many.
int dropCavities(const std::vector<float>& widths, const std::vector<Interface>& interfaces,
                 CellProposal& proposal);

}  // namespace enfilade
