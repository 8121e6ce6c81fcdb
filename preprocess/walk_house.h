#pragma once

#include <string>
#include <vector>

#include "preprocess/walk_grid.h"

namespace enfilade {

/// What the body can do of a walker with the house's eye height, whose head never touches.
WalkLimits walkLimitsOf(const House& house, float step_height = WalkLimits{}.step_height,
                        float head_room = WalkLimits{}.head_room);

/// Where one can walk in a house and on the ground around it, at a pitch of 5 cm or, where that
/// would be too many columns, more.  A model without ground before its doors gets some, which
/// `notes` then say.  Empty for a building without geometry.
WalkGrid walkGridOf(const House& house, const WalkLimits& limits, DoorsStand doors,
                    std::vector<std::string>& notes);

}  // namespace enfilade
