#include "preprocess/walk_search.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace enfilade {

namespace {

constexpr float kDislike = 3.0f;   // what a metre along a wall costs more than one in the open
constexpr float kSqueeze = 12.0f;  // what a metre costs more where the body does not fit easily
constexpr float kClimb = 1.5f;     // [m] walked rather than one climbed
constexpr float kFar = std::numeric_limits<float>::infinity();

}  // namespace

float costOfMetre(const WalkGrid& grid, const WalkCosts& costs, SpotId spot) noexcept {
  const float clearance = grid.clearance[spot];
  const bool outside = grid.cell[spot] == kExterior;
  const float lack = std::max(0.0f, 1.0f - clearance / (outside ? costs.airy : costs.comfort));
  const float squeeze = clearance < costs.body_radius ? kSqueeze : 0.0f;
  const float place = outside ? costs.outside : 1.0f;
  return place * (1.0f + kDislike * lack * lack + squeeze);
}

float costOfStep(const WalkGrid& grid, const WalkCosts& costs, SpotId from, SpotId to) noexcept {
  const float length = glm::length(grid.centerOf(to) - grid.centerOf(from));
  const float metre = 0.5f * (costOfMetre(grid, costs, from) + costOfMetre(grid, costs, to));
  return length * metre + kClimb * std::abs(grid.floor[to] - grid.floor[from]);
}

WalkSearch::WalkSearch(const WalkGrid& grid, const WalkCosts& costs)
    : grid_(grid),
      costs_(costs),
      cost_(grid.spotCount(), kFar),
      parent_(grid.spotCount(), kNoSpot) {}

void WalkSearch::reset() {
  for (const SpotId s : touched_) {
    cost_[s] = kFar;
    parent_[s] = kNoSpot;
  }
  touched_.clear();
}

SpotId WalkSearch::run(SpotId start, const std::function<bool(SpotId)>& stop,
                       const std::function<bool(SpotId)>& enter) {
  using Entry = std::pair<float, SpotId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  reset();
  cost_[start] = 0;
  touched_.push_back(start);
  queue.emplace(0.0f, start);
  while (!queue.empty()) {
    const auto [cost, spot] = queue.top();
    queue.pop();
    if (cost > cost_[spot]) continue;
    if (stop(spot)) return spot;
    for (int d = 0; d < 8; ++d) {
      const SpotId next = grid_.neighbour(spot, d);
      if (next == kNoSpot || grid_.clearance[next] < kNarrowestClearance) continue;
      if (enter && !enter(next)) continue;
      const float there = cost + costOfStep(grid_, costs_, spot, next);
      if (there >= cost_[next]) continue;
      if (cost_[next] == kFar) touched_.push_back(next);
      cost_[next] = there;
      parent_[next] = spot;
      queue.emplace(there, next);
    }
  }
  return kNoSpot;
}

std::vector<SpotId> WalkSearch::pathTo(SpotId spot) const {
  std::vector<SpotId> path;
  for (SpotId s = spot; s != kNoSpot; s = parent_[s]) path.push_back(s);
  std::reverse(path.begin(), path.end());
  return path;
}

std::vector<int> connectedParts(const WalkGrid& grid, float clearance) {
  std::vector<int> parts(grid.spotCount(), -1);
  std::vector<SpotId> open;
  int count = 0;
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (parts[s] >= 0 || grid.clearance[s] < clearance) continue;
    parts[s] = count;
    open.assign(1, s);
    while (!open.empty()) {
      const SpotId spot = open.back();
      open.pop_back();
      for (int d = 0; d < 8; ++d) {
        const SpotId next = grid.neighbour(spot, d);
        if (next == kNoSpot || parts[next] >= 0 || grid.clearance[next] < clearance) continue;
        parts[next] = count;
        open.push_back(next);
      }
    }
    ++count;
  }
  return parts;
}

}  // namespace enfilade
