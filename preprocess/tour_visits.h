#pragma once

#include <vector>

#include "preprocess/tour_ground.h"
#include "preprocess/walk_search.h"

namespace enfilade {

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
