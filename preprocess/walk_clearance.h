#pragma once

#include "preprocess/walk_grid.h"

namespace enfilade {

/// Distances beyond this are not told apart [m].
inline constexpr float kMostClearance = 1.5f;

/// Fills `grid.clearance`: from each spot's centre to the near side of the nearest column where one
/// cannot go on (a wall, a drop, furniture above the knee), along the floors that join them.
void measureClearance(WalkGrid& grid);

}  // namespace enfilade
