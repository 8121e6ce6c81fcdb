#pragma once

#include <string>
#include <vector>

#include "models/plan_layout.h"

namespace enfilade {

/// Checks that storeys fit on one another.  Throws Error (kBadInput) for outer walls that do not
/// stand on those below, rooms that reach into the storey above, and wells that come too near to
/// walls or to one another.
void checkStoreys(const FloorPlan& plan, const std::vector<Layout>& layouts,
                  const std::string& subject);

/// The wells through the floor of `room` (`side` 0) or the ceiling of `room` (`side` 1), of those
/// of one storey.
std::vector<PlanWell> wellsOf(const std::string& room, std::size_t side,
                              const std::vector<PlanWell>& wells);

/// A well's corners, of positive area.
std::vector<glm::dvec2> cornersOf(const PlanWell& well);

}  // namespace enfilade
