#pragma once

#include <string>
#include <vector>

#include "portals/house.h"

namespace enfilade {

/// A horizontal cut through a house: who owns each square.  Columns run along +x, rows along +z.
struct PlanSlice {
  float y = 0;          ///< [m] height of the cut
  glm::vec2 origin{0};  ///< x and z of the least corner [m]
  float voxel = 0.1f;   ///< edge of a square [m]
  int columns = 0, rows = 0;
  std::vector<CellGrid::Label> owner;  ///< row by row: a CellId, or kSolidVoxel

  CellGrid::Label at(int column, int row) const {
    return owner[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(column)];
  }
};

/// The cut through the whole grid at height `y` [m].  Squares that a portal crosses go to the cell
/// on whose side their centre lies.
PlanSlice sliceHouse(const CellGraph& graph, const CellGrid& grid, float y);

/// The outline of the squares that `label` owns, as closed loops of corners (column, row); filled
/// by the even-odd rule they are these squares.  Corners in a straight line are left out.
std::vector<std::vector<glm::ivec2>> traceOutline(const PlanSlice& slice, CellGrid::Label label);

/// Where a name has most room among the squares of `label`.
struct LabelPlace {
  glm::vec2 center{0};  ///< column and row, of the middle
  float width = 0;      ///< squares in a row about it; 0: the label owns none
  float height = 0;     ///< squares above and below it that are free
  int squares = 0;      ///< that the label owns in all
};
LabelPlace placeLabel(const PlanSlice& slice, CellGrid::Label label);

}  // namespace enfilade
