#pragma once

#include <string>
#include <vector>

#include "portals/cell_graph.h"
#include "portals/cell_grid.h"
#include "portals/leak.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// A cell graph that its voxels bear out.
struct CutCells {
  CellGraph graph;
  std::vector<CellGrid::Label> labels;  ///< dense, VoxelGrid's index
  CellGrid grid;                        ///< the same labels
  std::vector<std::string> log;  ///< the proposal's, and what was merged, added or dropped here
  std::vector<Leak> leaks;       ///< by what way those leak that are outdoors for it
};

/// Makes a proposal true: cuts the free voxels by every portal polygon, takes the connected
/// components of what is left as cells, each named as the proposed cell that owns most of it, and
/// gives each portal the cells found on its two sides; before several it stands once for each pair,
/// NAME#2 after the first.  Proposed cells that remain connected after
/// the cut become one; a portal with the same cell on both sides goes; free space that no one
/// proposed but that a portal opens to becomes a cell of its own; sealed cavities belong to nobody.
/// So every line of sight between two cells crosses a portal polygon, to the precision of a voxel.
CutCells cutCells(const VoxelGrid& voxels, const CellProposal& proposal);

}  // namespace enfilade
