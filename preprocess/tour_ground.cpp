#include "preprocess/tour_ground.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "preprocess/tour_entrance.h"
#include "preprocess/walk_search.h"
#include "scene/error.h"

namespace enfilade {

namespace {

constexpr float kRoomy = 1.2f;           // [m] more clearance makes a place no better
constexpr float kCentral = 0.08f;        // [1/m] of clearance given up to be near the middle
constexpr float kFarInside = 5.5f;       // [m] walked from a target: a large room has another there
constexpr float kFarClearance = 0.35f;   // [m] tighter places call for no target
constexpr std::size_t kMostTargets = 6;  // of one cell

// The part with the most rooms, then the most spots, −1 without any; the exterior is no room.
struct RichestPart {
  int part = -1;
  std::size_t rooms = 0;
};
RichestPart richestPart(const WalkGrid& grid, const std::vector<int>& parts) {
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
  RichestPart best;
  std::pair<std::size_t, std::size_t> most{0, 0};
  for (std::size_t p = 0; p < sizes.size(); ++p) {
    const std::pair rank(rooms[p].size(), sizes[p]);
    if (best.part >= 0 && rank <= most) continue;
    best = {static_cast<int>(p), rooms[p].size()};
    most = rank;
  }
  return best;
}

// The middle of each cell's spots, x and z.
std::vector<glm::vec2> middles(const WalkGrid& grid, const std::function<bool(SpotId)>& holds) {
  std::vector<glm::dvec2> sums(grid.cell_count, glm::dvec2(0));
  std::vector<double> counts(grid.cell_count, 0);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (!holds(s) || grid.cell[s] == kNoCell) continue;
    sums[grid.cell[s]] += glm::dvec2(grid.centerOf(s));
    counts[grid.cell[s]] += 1;
  }
  std::vector<glm::vec2> middles(grid.cell_count, glm::vec2(0));
  for (std::size_t c = 0; c < middles.size(); ++c) {
    if (counts[c] > 0) middles[c] = glm::vec2(sums[c] / counts[c]);
  }
  return middles;
}

// Without any room: the roomiest place.
SpotId roomiest(const WalkGrid& grid, const TourGround& ground) {
  SpotId best = kNoSpot;
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (ground.holds(s) && (best == kNoSpot || grid.clearance[s] > grid.clearance[best])) best = s;
  }
  return best;
}

// As good as no dislike of walls, so that cost is length.
constexpr WalkCosts kPlainMetres{
    .body_radius = 0.0f, .comfort = 1e-3f, .airy = 1e-3f, .outside = 1};

// How far each spot of a cell is from the cell's targets, walking inside it.
class CellReach {
 public:
  explicit CellReach(const WalkGrid& grid) : grid_(grid), search_(grid, kPlainMetres) {
    reach_.assign(grid.spotCount(), std::numeric_limits<float>::infinity());
  }

  void add(SpotId target) {
    const CellId cell = grid_.cell[target];
    const auto settle = [&](SpotId s) {
      reach_[s] = std::min(reach_[s], search_.costTo(s));
      return false;
    };
    search_.run(target, settle, [&](SpotId s) { return grid_.cell[s] == cell; });
  }

  float of(SpotId s) const { return reach_[s]; }

 private:
  const WalkGrid& grid_;
  WalkSearch search_;
  std::vector<float> reach_;
};

// A room that one cannot know from one place gets more targets, far from those it has.
void addFarTargets(const WalkGrid& grid, TourGround& ground) {
  CellReach reach(grid);
  std::vector<std::vector<SpotId>> spots(grid.cell_count);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    const CellId cell = grid.cell[s];
    if (!ground.holds(s) || cell == kNoCell || cell == kExterior) continue;
    if (grid.clearance[s] >= kFarClearance) spots[cell].push_back(s);
  }
  for (std::size_t cell = 0; cell < spots.size(); ++cell) {
    SpotId next = cell == kExterior ? kNoSpot : ground.target[cell];
    for (std::size_t count = 1; next != kNoSpot && count < kMostTargets; ++count) {
      reach.add(next);
      next = kNoSpot;
      float best = 0;
      for (const SpotId s : spots[cell]) {
        const float far = reach.of(s);
        if (far < kFarInside || std::isinf(far)) continue;
        const float score = far + 2.0f * std::min(grid.clearance[s], kRoomy);
        if (score <= best) continue;
        best = score;
        next = s;
      }
      if (next != kNoSpot) ground.more.push_back(next);
    }
  }
}

}  // namespace

std::vector<SpotId> bestSpots(const WalkGrid& grid, const std::function<bool(SpotId)>& holds) {
  std::vector<SpotId> spots(grid.cell_count, kNoSpot);
  std::vector<float> best(grid.cell_count, -std::numeric_limits<float>::infinity());
  const std::vector<glm::vec2> middle = middles(grid, holds);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    const CellId cell = grid.cell[s];
    if (!holds(s) || cell == kNoCell || cell == kExterior) continue;
    const float score = std::min(grid.clearance[s], kRoomy) -
                        kCentral * glm::length(grid.centerOf(s) - middle[cell]);
    if (score > best[cell]) {
      best[cell] = score;
      spots[cell] = s;
    }
  }
  return spots;
}

TourGround richestGround(const WalkGrid& grid) {
  TourGround ground;
  ground.parts = connectedParts(grid, kNarrowestClearance);
  ground.part = richestPart(grid, ground.parts).part;
  return ground;
}

std::size_t roomsReached(const WalkGrid& grid) {
  return richestPart(grid, connectedParts(grid, kNarrowestClearance)).rooms;
}

TourGround findGround(const House& house, const WalkGrid& grid) {
  TourGround ground = richestGround(grid);
  if (ground.part < 0) {
    throw Error(ErrorKind::kBadInput, house.info.model_name,
                "there is nowhere to stand: no floor with head room");
  }
  ground.target = bestSpots(grid, [&](SpotId s) { return ground.holds(s); });
  ground.target[kExterior] = placeOutside(house, grid, ground);
  const bool none = std::all_of(ground.target.begin(), ground.target.end(),
                                [](SpotId target) { return target == kNoSpot; });
  if (none) ground.target[kExterior] = roomiest(grid, ground);
  addFarTargets(grid, ground);
  return ground;
}

}  // namespace enfilade
