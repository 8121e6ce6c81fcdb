#pragma once

#include <string>
#include <vector>

#include "preprocess/tour_visits.h"

namespace enfilade {

/// Adds to `notes` why cells are not reached, a line each, and where the walk is narrower than
/// `body_radius`.
void explainWalk(const House& house, const WalkGrid& grid, const TourGround& ground,
                 const TourWalk& walk, float body_radius, std::vector<std::string>& notes);

}  // namespace enfilade
