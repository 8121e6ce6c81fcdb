#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/tour_visits.h"
#include "preprocess/walk_search.h"

namespace enfilade {

/// A walked line: points close together, each standing on a spot of the grid.
struct WalkPath {
  struct Point {
    glm::vec2 at{0};        ///< x and z [m]
    SpotId spot = kNoSpot;  ///< whose column holds `at`
    bool visit = false;     ///< stays in its cell, within 0.4 m of where it began
  };
  std::vector<Point> points;
};

/// The spot that a straight walk from `from` (in `spot`) to `to` ends on, and what it costs;
/// kNoSpot where a step of it is not possible or has less than `clearance` [m].
struct StraightWalk {
  SpotId end = kNoSpot;
  float cost = 0;
};
StraightWalk walkStraight(const WalkGrid& grid, const WalkCosts& costs, SpotId spot,
                          const glm::vec2& from, const glm::vec2& to, float clearance);

/// Pulls `walk` straight wherever that costs no more, rounds its corners as an elastic band does,
/// and gives points every 3 cm or so.
/// Invariant: every point is joined to the next by a straight walk with kNarrowestClearance.
/// Source: Quinlan & Khatib, Elastic Bands, 1993.
WalkPath smoothWalk(const WalkGrid& grid, const WalkCosts& costs, const TourWalk& walk);

}  // namespace enfilade
