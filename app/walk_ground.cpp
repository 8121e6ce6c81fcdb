#include "app/walk_ground.h"

#include <array>
#include <cmath>

#include "app/cell_spots.h"
#include "preprocess/walk_house.h"
#include "preprocess/walk_search.h"

namespace enfilade {

namespace {

constexpr float kFlightRoom = 2.0f;   // of the building's diagonal, around it
constexpr float kOtherRoom = 1.5f;    // [m] farther away, as good as, is a spot in another cell
constexpr float kNoFloor = 3.0f;      // [m] the same of one that is on no floor
constexpr float kFloorReach = 0.22f;  // [m] around a spot over which its floor is smoothed

int directionOf(const glm::ivec2& offset) noexcept {
  int direction = 0;
  while (direction < 8 &&
         offset != glm::ivec2(kDirections[direction][0], kDirections[direction][1])) {
    ++direction;
  }
  return direction;
}

Box flightBoundsOf(const House& house) {
  Box box = worldBounds(house.building);
  if (box.empty()) box.extend(glm::vec3(0));
  return box.grown(kFlightRoom * glm::length(box.size()) + 1.0f);
}

// What the spots from `start` on along one of the four directions of `links` and back hold.
struct FloorSum {
  float sum = 0;
  float count = 0;
  void add(const FloorSum& other) {
    sum += other.sum;
    count += other.count;
  }
};

FloorSum sumAlong(const WalkGrid& grid, SpotId start, std::size_t axis, int reach) {
  FloorSum total{grid.floor[start], 1};
  for (const std::size_t way : {axis, axis + 2}) {
    SpotId s = start;
    for (int i = 0; i < reach; ++i) {
      s = grid.links[s][way];
      if (s == kNoSpot) break;
      total.add({grid.floor[s], 1});
    }
  }
  return total;
}

}  // namespace

WalkGround::WalkGround(const House& house)
    : house_(house),
      grid_(walkGridOf(house, walkLimitsOf(house), DoorsStand::kAllOpen, notes_)),
      barriers_(walkBarriers(house)),
      flight_(flightBoundsOf(house)) {
  const TourGround ground = richestGround(grid_);
  on_floor_ = floorSpots(grid_, ground.parts);
  spots_ = cellSpots(house, grid_, ground, on_floor_);
  start_ = startCellOf(house, ground, spots_);
}

SpotId WalkGround::nearestSpot(const glm::vec3& eye) const {
  const CellLocation here = locate(house_.graph, house_.grid, eye);
  const CellId room = here.in_free_space ? here.cell : kNoCell;
  SpotId best = kNoSpot;
  float least = std::numeric_limits<float>::infinity();
  for (SpotId s = 0; s < grid_.spotCount(); ++s) {
    if (grid_.clearance[s] < kNarrowestClearance) continue;
    const glm::vec3 away = grid_.eyeOf(s) - eye;
    const bool same = grid_.cell[s] == room;
    const float cost =
        glm::length(glm::vec2(away.x, away.z)) + std::abs(away.y) * (same ? 0.5f : 1.0f) +
        (same || room == kNoCell ? 0.0f : kOtherRoom) + (on_floor_[s] != 0 ? 0.0f : kNoFloor);
    if (cost >= least) continue;
    least = cost;
    best = s;
  }
  return best;
}

SpotId WalkGround::stepTo(SpotId spot, const glm::vec2& to) const noexcept {
  const glm::ivec2 offset = grid_.columnAt(to) - grid_.columnOf(spot);
  if (offset == glm::ivec2(0)) return spot;
  const int direction = directionOf(offset);
  const SpotId next = direction < 8 ? grid_.neighbour(spot, direction) : kNoSpot;
  return next == kNoSpot || grid_.clearance[next] < kNarrowestClearance ? kNoSpot : next;
}

// Bilinear between the centres of four columns; what is no spot lies half a column inside a wall.
float WalkGround::clearanceAt(SpotId spot, const glm::vec2& at) const noexcept {
  const glm::vec2 off = (at - grid_.centerOf(spot)) / grid_.pitch;
  const glm::ivec2 base(glm::floor(off));
  const glm::vec2 t = off - glm::vec2(base);
  const auto value = [&](const glm::ivec2& offset) {
    SpotId s = spot;
    // At most two columns away: one step, or two.
    for (glm::ivec2 left = offset; s != kNoSpot && left != glm::ivec2(0);) {
      const glm::ivec2 step = glm::clamp(left, glm::ivec2(-1), glm::ivec2(1));
      s = grid_.neighbour(s, directionOf(step));
      left -= step;
    }
    return s == kNoSpot ? -0.5f * grid_.pitch : grid_.clearance[s];
  };
  const float low = glm::mix(value(base), value(base + glm::ivec2(1, 0)), t.x);
  const float high = glm::mix(value(base + glm::ivec2(0, 1)), value(base + glm::ivec2(1)), t.x);
  return glm::mix(low, high, t.y);
}

float WalkGround::smoothFloor(SpotId spot) const noexcept {
  const int reach = static_cast<int>(kFloorReach / grid_.pitch);
  FloorSum total = sumAlong(grid_, spot, 1, reach);
  for (const std::size_t way : {std::size_t{0}, std::size_t{2}}) {
    SpotId s = spot;
    for (int i = 0; i < reach; ++i) {
      s = grid_.links[s][way];
      if (s == kNoSpot) break;
      total.add(sumAlong(grid_, s, 1, reach));
    }
  }
  return total.sum / total.count;
}

}  // namespace enfilade
