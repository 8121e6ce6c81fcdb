#include "preprocess/tour_visits.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "scene/error.h"

namespace enfilade {

namespace {

constexpr float kSeenLeast = 0.3f;  // [m] passing a target this near is a visit,
constexpr float kSeenMost = 1.0f;   // [m] or, where there is room, this near

SpotId startOf(const WalkGrid& grid, const TourGround& ground) {
  if (ground.target[kExterior] != kNoSpot) return ground.target[kExterior];
  std::vector<std::size_t> sizes(grid.cell_count, 0);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (ground.holds(s) && grid.cell[s] != kNoCell) ++sizes[grid.cell[s]];
  }
  const auto largest = std::max_element(sizes.begin(), sizes.end());
  return ground.target[static_cast<std::size_t>(largest - sizes.begin())];
}

// [m]; infinite from another cell or another floor.
float distanceToTarget(const WalkGrid& grid, SpotId s, SpotId target) {
  const bool same = grid.cell[s] == grid.cell[target] &&
                    std::abs(grid.floor[s] - grid.floor[target]) <= grid.limits.step_height;
  return same ? glm::length(grid.centerOf(s) - grid.centerOf(target))
              : std::numeric_limits<float>::infinity();
}

// A target is visited where the walk comes nearest to it.
void markVisits(const WalkGrid& grid, const std::vector<SpotId>& targets, TourWalk& walk) {
  std::set<std::size_t> visits;
  for (const SpotId target : targets) {
    float least = std::numeric_limits<float>::infinity();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < walk.spots.size(); ++i) {
      const float distance = distanceToTarget(grid, walk.spots[i], target);
      if (distance < least) {
        least = distance;
        nearest = i;
      }
    }
    if (least <= kSeenMost) visits.insert(nearest);
  }
  walk.visits.assign(visits.begin(), visits.end());
}

}  // namespace

TourWalk walkThrough(const House& house, const WalkGrid& grid, const WalkCosts& costs,
                     const TourGround& ground) {
  std::vector<SpotId> open;
  for (const SpotId target : ground.target) {
    if (target != kNoSpot) open.push_back(target);
  }
  open.insert(open.end(), ground.more.begin(), ground.more.end());
  if (open.empty()) {
    throw Error(ErrorKind::kBadInput, house.info.model_name, "there is nowhere to walk");
  }
  const std::vector<SpotId> targets = open;
  const auto pass = [&](SpotId s) {
    std::erase_if(open, [&](SpotId target) {
      return distanceToTarget(grid, s, target) <=
             std::clamp(grid.clearance[target], kSeenLeast, kSeenMost);
    });
  };
  TourWalk walk;
  SpotId here = startOf(grid, ground);
  if (here == kNoSpot) here = open.front();
  walk.spots.push_back(here);
  pass(here);
  WalkSearch search(grid, costs);
  while (!open.empty()) {
    const SpotId next = search.run(
        here, [&](SpotId s) { return std::find(open.begin(), open.end(), s) != open.end(); });
    if (next == kNoSpot) break;
    const std::vector<SpotId> path = search.pathTo(next);
    for (std::size_t i = 1; i < path.size(); ++i) {
      walk.spots.push_back(path[i]);
      pass(path[i]);
    }
    here = next;
  }
  markVisits(grid, targets, walk);
  return walk;
}

}  // namespace enfilade
