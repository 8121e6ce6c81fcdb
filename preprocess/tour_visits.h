#pragma once

#include <vector>

#include "preprocess/walk_search.h"

namespace enfilade {

/// Where a tour may go: the connected part of the spots that holds the most rooms.
struct TourGround {
  std::vector<int> parts;      ///< connectedParts of the grid
  int part = -1;               ///< the tour's
  std::vector<SpotId> target;  ///< of each cell: where it is best seen from; kNoSpot: not reached

  bool holds(SpotId s) const noexcept { return parts[s] == part; }
};

/// Throws Error (kBadInput) if there is nowhere to stand.
TourGround findGround(const House& house, const WalkGrid& grid);

/// A walk from spot to spot, with the places in it that a visit is made at.
struct TourWalk {
  std::vector<SpotId> spots;        ///< each joined to the next by one step
  std::vector<std::size_t> visits;  ///< indices in `spots`, increasing
};

/// The walk through every target: from the entrance, if the exterior is among them, else from the
/// largest room; then each time to the target that is the shortest walk away.
TourWalk walkThrough(const House& house, const WalkGrid& grid, const WalkCosts& costs,
                     const TourGround& ground);

}  // namespace enfilade
