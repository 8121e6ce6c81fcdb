#pragma once

#include <vector>

#include "preprocess/walk_grid.h"

namespace enfilade {

/// Where a tour may go: the connected part of the spots that holds the most rooms.
struct TourGround {
  std::vector<int> parts;      ///< connectedParts of the grid
  int part = -1;               ///< the tour's
  std::vector<SpotId> target;  ///< of each cell: where it is best seen from; kNoSpot: not reached
  std::vector<SpotId> more;    ///< further targets in large rooms

  bool holds(SpotId s) const noexcept { return parts[s] == part; }
};

/// Throws Error (kBadInput) if there is nowhere to stand.
TourGround findGround(const House& house, const WalkGrid& grid);

}  // namespace enfilade
