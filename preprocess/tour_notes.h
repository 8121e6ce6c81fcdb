#pragma once

#include <string>
#include <vector>

#include "preprocess/tour_visits.h"

namespace enfilade {

/// Why cells are not reached, a line each, and where the walk is narrower than `body_radius`.
std::vector<std::string> explainWalk(const House& house, const WalkGrid& grid,
                                     const TourGround& ground, const TourWalk& walk,
                                     float body_radius);

}  // namespace enfilade
