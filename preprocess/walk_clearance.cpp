#include "preprocess/walk_clearance.h"

#include <cmath>

namespace enfilade {

namespace {

// A brush fire that carries the nearest obstacle's column along (dead reckoning), in buckets of
// squared distance.
class BrushFire {
 public:
  explicit BrushFire(const WalkGrid& grid) : grid_(grid) {
    const auto reach = static_cast<std::size_t>(kMostClearance / grid.pitch) + 1;
    buckets_.resize(reach * reach + 1);
    nearest_.assign(grid.spotCount(), glm::ivec2(0));
    squared_.assign(grid.spotCount(), static_cast<int>(buckets_.size()));
  }

  void run() {
    for (SpotId s = 0; s < grid_.spotCount(); ++s) light(s);
    for (std::size_t d = 0; d < buckets_.size(); ++d) {
      for (std::size_t i = 0; i < buckets_[d].size(); ++i) {
        const SpotId s = buckets_[d][i];
        if (squared_[s] == static_cast<int>(d)) spread(s);
      }
      buckets_[d] = {};
    }
  }

  float clearanceOf(SpotId s) const {
    return (std::sqrt(static_cast<float>(squared_[s])) - 0.5f) * grid_.pitch;
  }

 private:
  void offer(SpotId s, const glm::ivec2& obstacle) {
    const glm::ivec2 away = grid_.columnOf(s) - obstacle;
    const int squared = away.x * away.x + away.y * away.y;
    if (squared >= squared_[s]) return;
    squared_[s] = squared;
    nearest_[s] = obstacle;
    buckets_[static_cast<std::size_t>(squared)].push_back(s);
  }

  void light(SpotId s) {
    for (int d = 0; d < 8; ++d) {
      if (grid_.neighbour(s, d) != kNoSpot) continue;
      offer(s, grid_.columnOf(s) + glm::ivec2(kDirections[d][0], kDirections[d][1]));
    }
  }

  void spread(SpotId s) {
    for (int d = 0; d < 8; ++d) {
      const SpotId next = grid_.neighbour(s, d);
      if (next != kNoSpot) offer(next, nearest_[s]);
    }
  }

  const WalkGrid& grid_;
  std::vector<std::vector<SpotId>> buckets_;
  std::vector<glm::ivec2> nearest_;
  std::vector<int> squared_;
};

}  // namespace

void measureClearance(WalkGrid& grid) {
  BrushFire fire(grid);
  fire.run();
  grid.clearance.resize(grid.spotCount());
  for (SpotId s = 0; s < grid.spotCount(); ++s) grid.clearance[s] = fire.clearanceOf(s);
}

}  // namespace enfilade
