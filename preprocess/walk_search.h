#pragma once

#include <functional>
#include <vector>

#include "preprocess/walk_grid.h"

namespace enfilade {

/// What walking costs: metres, dearer near walls and outside.
struct WalkCosts {
  float body_radius = 0.2f;  ///< [m] [> 0] closer to a wall than this only where there is no choice
  float comfort = 0.6f;      ///< [m] [> body_radius] closer to a wall than this is disliked
  float airy = 1.4f;         ///< [m] [> body_radius] the same in the exterior
  float outside = 1.3f;      ///< [≥ 1] a metre in the exterior costs as much as this inside
};

/// The cost of a metre at `spot` [≥ 1].
float costOfMetre(const WalkGrid& grid, const WalkCosts& costs, SpotId spot) noexcept;

/// The cost of the step between two joined spots.
float costOfStep(const WalkGrid& grid, const WalkCosts& costs, SpotId from, SpotId to) noexcept;

/// Shortest walks from one spot (Dijkstra 1959), over spots with at least kNarrowestClearance.
/// Ties fall to the spot of the lowest number. Keeps its buffers between calls.
class WalkSearch {
 public:
  WalkSearch(const WalkGrid& grid, const WalkCosts& costs);

  /// Settles spots in order of cost until `stop` accepts one, which it returns; kNoSpot if it
  /// accepts none. `enter` (may be empty) tells which spots may be entered.
  SpotId run(SpotId start, const std::function<bool(SpotId)>& stop,
             const std::function<bool(SpotId)>& enter = {});

  float costTo(SpotId spot) const noexcept { return cost_[spot]; }  ///< infinite where not reached
  std::vector<SpotId> pathTo(SpotId spot) const;  ///< of a settled spot, the start included

 private:
  void reset();

  const WalkGrid& grid_;
  WalkCosts costs_;
  std::vector<float> cost_;
  std::vector<SpotId> parent_;
  std::vector<SpotId> touched_;
};

/// The connected parts of the spots with at least `clearance` [m]: a number a spot, −1 where it has
/// less. Numbered by their lowest spot.
std::vector<int> connectedParts(const WalkGrid& grid, float clearance);

}  // namespace enfilade
