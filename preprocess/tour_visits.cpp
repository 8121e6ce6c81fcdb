#include "preprocess/tour_visits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "scene/error.h"

namespace enfilade {

namespace {

constexpr float kRoomy = 1.2f;        // [m] more clearance makes a place no better
constexpr float kCentral = 0.08f;     // [1/m] of clearance given up to be near the middle
constexpr float kStepOutside = 2.0f;  // [m] how far before the entrance a tour starts
constexpr float kSeenLeast = 0.3f;    // [m] passing a target this near is a visit,
constexpr float kSeenMost = 1.0f;     // [m] or, where there is room, this near

// The number of rooms and of spots in each part; the exterior is no room.
int richestPart(const WalkGrid& grid, const std::vector<int>& parts) {
  int count = 0;
  for (const int part : parts) count = std::max(count, part + 1);
  std::vector<std::set<CellId>> rooms(static_cast<std::size_t>(count));
  std::vector<std::size_t> sizes(static_cast<std::size_t>(count), 0);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (parts[s] < 0) continue;
    const auto part = static_cast<std::size_t>(parts[s]);
    ++sizes[part];
    if (grid.cell[s] != kExterior && grid.cell[s] != kNoCell) rooms[part].insert(grid.cell[s]);
  }
  int best = -1;
  for (int p = 0; p < count; ++p) {
    const auto rank = [&](int q) {
      const auto i = static_cast<std::size_t>(q);
      return std::pair(rooms[i].size(), sizes[i]);
    };
    if (best < 0 || rank(p) > rank(best)) best = p;
  }
  return best;
}

// The exterior's spots next to a room, best entrance first.
struct Entrance {
  bool door = false;
  float floor = 0;
  float area = 0;
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
    return std::tuple(e.outside != kNoSpot, e.door, -std::round(2.0f * e.floor), e.area);
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
      entrance.outside = s;
      entrance.outward = -glm::vec2(kDirections[d][0], kDirections[d][1]);
      if (rank(entrance) > rank(best)) best = entrance;
    }
  }
  return best;
}

// A short step outside: straight before the entrance, with room around.
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

// The middle of each cell's spots, x and z.
std::vector<glm::vec2> middles(const WalkGrid& grid, const TourGround& ground) {
  std::vector<glm::dvec2> sums(grid.cell_count, glm::dvec2(0));
  std::vector<double> counts(grid.cell_count, 0);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (!ground.holds(s) || grid.cell[s] == kNoCell) continue;
    sums[grid.cell[s]] += glm::dvec2(grid.centerOf(s));
    counts[grid.cell[s]] += 1;
  }
  std::vector<glm::vec2> middles(grid.cell_count, glm::vec2(0));
  for (std::size_t c = 0; c < middles.size(); ++c) {
    if (counts[c] > 0) middles[c] = glm::vec2(sums[c] / counts[c]);
  }
  return middles;
}

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

// Without any room: the roomiest place.
SpotId roomiest(const WalkGrid& grid, const TourGround& ground) {
  SpotId best = kNoSpot;
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (ground.holds(s) && (best == kNoSpot || grid.clearance[s] > grid.clearance[best])) best = s;
  }
  return best;
}

}  // namespace

TourGround findGround(const House& house, const WalkGrid& grid) {
  TourGround ground;
  ground.parts = connectedParts(grid, kNarrowestClearance);
  ground.part = richestPart(grid, ground.parts);
  if (ground.part < 0) {
    throw Error(ErrorKind::kBadInput, house.info.model_name,
                "there is nowhere to stand: no floor with head room");
  }
  ground.target.assign(grid.cell_count, kNoSpot);
  std::vector<float> best(grid.cell_count, -std::numeric_limits<float>::infinity());
  const std::vector<glm::vec2> middle = middles(grid, ground);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    const CellId cell = grid.cell[s];
    if (!ground.holds(s) || cell == kNoCell || cell == kExterior) continue;
    const float score = std::min(grid.clearance[s], kRoomy) -
                        kCentral * glm::length(grid.centerOf(s) - middle[cell]);
    if (score > best[cell]) {
      best[cell] = score;
      ground.target[cell] = s;
    }
  }
  ground.target[kExterior] = placeOutside(house, grid, ground);
  const bool none = std::all_of(ground.target.begin(), ground.target.end(),
                                [](SpotId target) { return target == kNoSpot; });
  if (none) ground.target[kExterior] = roomiest(grid, ground);
  return ground;
}

TourWalk walkThrough(const House& house, const WalkGrid& grid, const WalkCosts& costs,
                     const TourGround& ground) {
  std::vector<SpotId> open;
  for (const SpotId target : ground.target) {
    if (target != kNoSpot) open.push_back(target);
  }
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
