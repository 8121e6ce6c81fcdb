#include "preprocess/tour_entrance.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "preprocess/walk_search.h"

namespace enfilade {

namespace {

constexpr float kRoomy = 1.2f;        // [m] more clearance makes a place no better
constexpr float kStepOutside = 2.0f;  // [m] how far before the entrance a tour starts

// The exterior's spots next to a room, best entrance first.
struct Entrance {
  bool door = false;
  float floor = 0;
  float area = 0;
  float clearance = 0;
  SpotId outside = kNoSpot;
  glm::vec2 outward{0};
};

const Portal* nearestWayOut(const House& house, CellId room, const glm::vec3& eye) {
  const Portal* best = nullptr;
  float least = std::numeric_limits<float>::infinity();
  for (const Portal& portal : house.graph.portals) {
    const bool joins = (portal.front == kExterior && portal.back == room) ||
                       (portal.back == kExterior && portal.front == room);
    if (!joins || portal.polygon.empty()) continue;
    const float distance = glm::length(portal.center() - eye);
    if (distance < least) {
      least = distance;
      best = &portal;
    }
  }
  return best;
}

Entrance bestEntrance(const House& house, const WalkGrid& grid, const TourGround& ground) {
  Entrance best;
  const auto rank = [](const Entrance& e) {
    return std::tuple(e.outside != kNoSpot, e.door, -std::round(2.0f * e.floor), e.area,
                      e.clearance);
  };
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (!ground.holds(s) || grid.cell[s] != kExterior) continue;
    for (int d = 0; d < 8; d += 2) {
      const SpotId in = grid.neighbour(s, d);
      if (in == kNoSpot || grid.cell[in] == kExterior || grid.cell[in] == kNoCell) continue;
      const Portal* portal = nearestWayOut(house, grid.cell[in], grid.eyeOf(s));
      Entrance entrance;
      entrance.door = portal != nullptr && portal->kind == PortalKind::kDoor;
      entrance.floor = grid.floor[in];
      entrance.area = portal != nullptr ? portal->area() : 0.0f;
      entrance.clearance = grid.clearance[s];
      entrance.outside = s;
      entrance.outward = -glm::vec2(kDirections[d][0], kDirections[d][1]);
      if (rank(entrance) > rank(best)) best = entrance;
    }
  }
  return best;
}

}  // namespace

SpotId placeOutside(const House& house, const WalkGrid& grid, const TourGround& ground) {
  const Entrance entrance = bestEntrance(house, grid, ground);
  if (entrance.outside == kNoSpot) return kNoSpot;
  WalkSearch search(grid, {});
  SpotId best = entrance.outside;
  float best_score = -1.0f;
  const glm::vec2 door = grid.centerOf(entrance.outside);
  const auto look = [&](SpotId s) {
    const glm::vec2 offset = grid.centerOf(s) - door;
    const float distance = glm::length(offset);
    const float ahead = glm::dot(offset, entrance.outward);
    const float score = std::min(ahead, kStepOutside) - std::max(0.0f, distance - ahead) +
                        std::min(grid.clearance[s], kRoomy);
    if (distance <= 1.5f * kStepOutside && score > best_score) {
      best = s;
      best_score = score;
    }
    return search.costTo(s) > 4.0f * kStepOutside;
  };
  search.run(entrance.outside, look, [&](SpotId s) { return grid.cell[s] == kExterior; });
  return best;
}

}  // namespace enfilade
