#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/interfaces.h"

namespace enfilade {

/// Numbers the cells that are left, and their voxels.  `into` has one entry a cell: itself, a cell
/// before it that it becomes part of, or CellProposal::kNobody to give it up.
void mergeCells(const std::vector<std::uint16_t>& into, CellProposal& proposal);

/// For each of `cells` cells the first of those that interfaces join it to, over others or not.
std::vector<std::uint16_t> joinedCells(std::size_t cells, const std::vector<Interface>& interfaces);

/// Gives up cells that nothing joins to the exterior or to any wide enough to be a room (shafts,
/// the insides of thick walls), and those with a flag in `inside`.  `widths` [m], one a cell.
/// Returns how many.
int dropCavities(const std::vector<float>& widths, const std::vector<std::uint8_t>& inside,
                 const std::vector<Interface>& interfaces, CellProposal& proposal);

}  // namespace enfilade
