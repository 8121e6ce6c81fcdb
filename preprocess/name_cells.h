#pragma once

#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/storeys.h"
#include "preprocess/wall_faces.h"

namespace enfilade {

/// Fills the proposal's storeys: where most of each floor lies.
void nameStoreys(const VoxelGrid& voxels, const WallFaces& walls,
                 const std::vector<StoreyBand>& bands, CellProposal& proposal);

/// Drops storeys that no cell stands on: roofs, and what trees reach over.  At least one stays.
void dropEmptyStoreys(CellProposal& proposal);

/// Names the cells that have no name yet after their storey, numbered in order.
void nameCells(CellProposal& proposal);

/// Names each portal that has no name yet after its kind and cells, and numbers those that would be
/// called the same.
void namePortals(CellProposal& proposal);

}  // namespace enfilade
