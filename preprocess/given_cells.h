#pragma once

#include "portals/given_graph.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/cut_cells.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// The cells and portals of a given graph, for cutCells().  Voxels go to the cell that its grid
/// says.  Those of cells that the grid does not know (all of them without one) are what their
/// bounds hold, the smallest first.
CellProposal givenCells(const GivenGraph& given, const VoxelGrid& voxels);

/// Turns the portals whose front and back the graph gives the other way round, so that one-way
/// portals lead where it says, and logs what of it did not come true: portals that join other
/// cells, cells that are gone.
void compareWithGiven(const GivenGraph& given, CutCells& cells);

}  // namespace enfilade
