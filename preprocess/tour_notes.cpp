#include "preprocess/tour_notes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kHighestClimb = 1.5f;  // [m] a drop or step that is worth naming

// Spots that the tour's part reaches if `joined` says what one may step over.
template <typename Neighbours>
std::vector<char> flood(const WalkGrid& grid, const TourGround& ground, const Neighbours& each) {
  std::vector<char> reached(grid.spotCount(), 0);
  std::vector<SpotId> open;
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (!ground.holds(s)) continue;
    reached[s] = 1;
    open.push_back(s);
  }
  while (!open.empty()) {
    const SpotId spot = open.back();
    open.pop_back();
    each(spot, [&](SpotId next) {
      if (next == kNoSpot || reached[next] != 0) return;
      reached[next] = 1;
      open.push_back(next);
    });
  }
  return reached;
}

// What is in the way of the cells that the walk does not reach.
class Reasons {
 public:
  Reasons(const House& house, const WalkGrid& grid, const TourGround& ground)
      : house_(house), grid_(grid) {
    cell_.resize(grid.spotCount());
    for (SpotId s = 0; s < grid.spotCount(); ++s) {
      cell_[s] = grid.cell[s] != kNoCell ? grid.cell[s]
                                         : locate(house.graph, house.grid, grid.eyeOf(s)).cell;
    }
    // Each asks for one thing less than a walker needs.
    leaking_ = flood(grid, ground, [&](SpotId s, const auto& visit) {
      aside(s, grid.limits.step_height, [&](SpotId next) {
        if (grid_.clearance[next] >= kNarrowestClearance) visit(next);
      });
    });
    thin_ = flood(grid, ground,
                  [&](SpotId s, const auto& visit) { aside(s, grid.limits.step_height, visit); });
    climbing_ =
        flood(grid, ground, [&](SpotId s, const auto& visit) { aside(s, kHighestClimb, visit); });
  }

  std::string of(CellId cell) const {
    bool stands = false;
    bool fits = false;
    bool leaks = false;
    bool squeezes = false;
    bool climbs = false;
    for (SpotId s = 0; s < grid_.spotCount(); ++s) {
      if (cell_[s] != cell) continue;
      stands = true;
      fits = fits || grid_.clearance[s] >= kNarrowestClearance;
      leaks = leaks || leaking_[s] != 0;
      squeezes = squeezes || thin_[s] != 0;
      climbs = climbs || climbing_[s] != 0;
    }
    if (!stands) {
      return fmt::format("no floor with {:.2f} m of head room", grid_.limits.head_room);
    }
    if (!fits) return fmt::format("nowhere wider than {:.2f} m", 2 * kNarrowestClearance);
    if (!anyPortal(cell)) return "no portal leads there";
    if (leaks) return "the only way in crosses no open portal";
    if (squeezes)
      return fmt::format("the way in is narrower than {:.2f} m", 2 * kNarrowestClearance);
    if (onlyWindows(cell)) return "only windows lead there";
    if (climbs) return fmt::format("a step higher than {:.2f} m", grid_.limits.step_height);
    return "no floor leads there";
  }

 private:
  template <typename Visit>
  void aside(SpotId s, float step, const Visit& visit) const {
    for (int d = 0; d < 8; d += 2) {
      const glm::ivec2 there = grid_.columnOf(s) + glm::ivec2(kDirections[d][0], kDirections[d][1]);
      const SpotId next = grid_.spotInColumn(s, there, step);
      if (next != kNoSpot) visit(next);
    }
  }

  bool anyPortal(CellId cell) const {
    return std::any_of(
        house_.graph.portals.begin(), house_.graph.portals.end(),
        [&](const Portal& p) { return p.active && (p.front == cell || p.back == cell); });
  }

  bool onlyWindows(CellId cell) const {
    bool any = false;
    for (const Portal& portal : house_.graph.portals) {
      if (portal.front != cell && portal.back != cell) continue;
      if (portal.kind != PortalKind::kWindow) return false;
      any = true;
    }
    return any;
  }

  const House& house_;
  const WalkGrid& grid_;
  std::vector<CellId> cell_;
  std::vector<char> leaking_;
  std::vector<char> thin_;
  std::vector<char> climbing_;
};

// A line for each narrow stretch of the walk.
void noteNarrows(const House& house, const WalkGrid& grid, const TourWalk& walk, float body_radius,
                 std::vector<std::string>& notes) {
  for (std::size_t i = 0; i < walk.spots.size(); ++i) {
    float least = body_radius;
    SpotId narrowest = kNoSpot;
    for (; i < walk.spots.size() && grid.clearance[walk.spots[i]] < body_radius; ++i) {
      if (grid.clearance[walk.spots[i]] < least) {
        least = grid.clearance[walk.spots[i]];
        narrowest = walk.spots[i];
      }
    }
    if (narrowest == kNoSpot) continue;
    const glm::vec3 p = grid.eyeOf(narrowest);
    const CellId cell = grid.cell[narrowest];
    std::string line =
        fmt::format("narrow: {:.2f} m to either side at ({:.1f}, {:.1f}, {:.1f}), {}", least, p.x,
                    p.y, p.z, cell < grid.cell_count ? house.graph.cells[cell].name : "no cell");
    if (std::find(notes.begin(), notes.end(), line) == notes.end()) notes.push_back(line);
  }
}

}  // namespace

void explainWalk(const House& house, const WalkGrid& grid, const TourGround& ground,
                 const TourWalk& walk, float body_radius, std::vector<std::string>& notes) {
  const bool all = std::none_of(ground.target.begin(), ground.target.end(),
                                [](SpotId target) { return target == kNoSpot; });
  if (!all) {
    const Reasons reasons(house, grid, ground);
    for (CellId cell = 0; cell < grid.cell_count; ++cell) {
      if (ground.target[cell] != kNoSpot) continue;
      notes.push_back(
          fmt::format("not reached: {}: {}", house.graph.cells[cell].name, reasons.of(cell)));
    }
  }
  noteNarrows(house, grid, walk, body_radius, notes);
}

}  // namespace enfilade
