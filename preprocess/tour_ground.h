#pragma once

#include <functional>
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

/// Of each cell the spot, of those that `holds` accepts, with the most room around that is not far
/// from the cell's middle; kNoSpot where there is none, and for the exterior.
std::vector<SpotId> bestSpots(const WalkGrid& grid, const std::function<bool(SpotId)>& holds);

/// The part alone, −1 if there is nowhere to stand; no targets.
TourGround richestGround(const WalkGrid& grid);

/// The number of rooms in it.
std::size_t roomsReached(const WalkGrid& grid);

/// Throws Error (kBadInput) if there is nowhere to stand.
TourGround findGround(const House& house, const WalkGrid& grid);

}  // namespace enfilade
