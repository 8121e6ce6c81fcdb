#pragma once

#include "preprocess/tour_ground.h"

namespace enfilade {

/// A short step outside: straight before the best entrance (a door, low, wide), with room around;
/// kNoSpot if `ground` leads to no exterior.
SpotId placeOutside(const House& house, const WalkGrid& grid, const TourGround& ground);

}  // namespace enfilade
