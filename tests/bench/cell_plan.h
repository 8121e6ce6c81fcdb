#pragma once

#include <string>

#include "cell_truth.h"
#include "preprocess/cut_cells.h"

namespace enfilade {

/// The cell of a voxel; the exterior outside the grid.
inline CellGrid::Label labelAt(const VoxelGrid& grid, const CutCells& cut, const glm::ivec3& v) {
  return grid.contains(v) ? cut.labels[grid.index(v.x, v.y, v.z)] : CellGrid::Label{0};
}

/// Draws the cells at height `y` [m] from above, each in a colour of its own, solid in black,
/// sealed cavities in purple; doors in red, windows in blue, openings in green, the truth's as
/// crosses.
void drawPlan(const std::string& file, const VoxelGrid& grid, const CutCells& cut, float y,
              const Truth& truth);

}  // namespace enfilade
