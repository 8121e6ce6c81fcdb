#include "preprocess/walk_grid.h"

#include <algorithm>
#include <cmath>

#include "preprocess/walk_clearance.h"

namespace enfilade {

namespace {

constexpr float kWidestGap = 0.4f;    // [m] of missing floor that one steps over
constexpr float kFloorSlack = 0.02f;  // [m] of unevenness that is no obstacle
constexpr float kSky = std::numeric_limits<float>::infinity();

struct Spot {
  float floor;
  float ceiling;
};
using ColumnSpots = std::vector<std::vector<Spot>>;

// The free stretch of a column that holds `floor` up to the head, or ceiling < floor.
Spot freeAbove(const std::vector<SolidSpan>& spans, float floor) {
  Spot spot{floor, kSky};
  for (const SolidSpan& span : spans) {
    if (span.top <= floor + kFloorSlack) continue;
    spot.ceiling = span.bottom;
    break;
  }
  return spot;
}

ColumnSpots standingRoom(const WalkColumns& columns, float head_room) {
  ColumnSpots spots(columns.spans.size());
  for (std::size_t c = 0; c < spots.size(); ++c) {
    const std::vector<SolidSpan>& spans = columns.spans[c];
    for (std::size_t i = 0; i < spans.size(); ++i) {
      const float ceiling = i + 1 < spans.size() ? spans[i + 1].bottom : kSky;
      if (!spans[i].steep && ceiling - spans[i].top >= head_room) {
        spots[c].push_back({spans[i].top, ceiling});
      }
    }
  }
  return spots;
}

bool joins(const Spot& a, const Spot& b, const WalkLimits& limits) {
  return std::abs(a.floor - b.floor) <= limits.step_height &&
         std::min(a.ceiling, b.ceiling) - std::max(a.floor, b.floor) >= limits.head_room;
}

const Spot* joinedIn(const std::vector<Spot>& column, const Spot& spot, const WalkLimits& limits) {
  for (const Spot& other : column) {
    if (joins(spot, other, limits)) return &other;
  }
  return nullptr;
}

void insertSpot(std::vector<Spot>& column, const Spot& spot, float apart) {
  for (const Spot& other : column) {
    if (std::abs(other.floor - spot.floor) < apart) return;
  }
  const auto above = std::find_if(column.begin(), column.end(),
                                  [&](const Spot& other) { return other.floor > spot.floor; });
  column.insert(above, spot);
}

// Lays a floor over gaps that one steps over: cracks between slabs, a doorway without a threshold.
class GapBridge {
 public:
  GapBridge(const WalkColumns& columns, const WalkLimits& limits, ColumnSpots& spots)
      : columns_(columns), limits_(limits), spots_(spots) {
    reach_ = static_cast<int>(kWidestGap / columns.pitch) + 1;
  }

  void run() {
    for (int x = 0; x < columns_.size.x; ++x) {
      for (int z = 0; z < columns_.size.y; ++z) {
        for (const Spot& spot : spots_[columns_.index({x, z})]) {
          tryFrom({x, z}, {1, 0}, spot);
          tryFrom({x, z}, {0, 1}, spot);
        }
      }
    }
    for (const auto& [column, spot] : found_) insertSpot(spots_[column], spot, limits_.step_height);
  }

 private:
  void tryFrom(const glm::ivec2& start, const glm::ivec2& direction, const Spot& spot) {
    std::vector<std::pair<std::size_t, Spot>> gap;
    for (int k = 1; k <= reach_; ++k) {
      const glm::ivec2 c = start + k * direction;
      if (!columns_.contains(c)) return;
      const Spot* far_side = joinedIn(spots_[columns_.index(c)], spot, limits_);
      if (far_side != nullptr) {
        found_.insert(found_.end(), gap.begin(), gap.end());
        return;
      }
      const Spot over = freeAbove(columns_.spans[columns_.index(c)], spot.floor);
      if (over.ceiling - over.floor < limits_.head_room) return;
      gap.emplace_back(columns_.index(c), over);
    }
  }

  const WalkColumns& columns_;
  const WalkLimits& limits_;
  ColumnSpots& spots_;
  int reach_ = 0;
  std::vector<std::pair<std::size_t, Spot>> found_;
};

// Earth around the building, level with `ground`, wherever the eye above it is outside.
void addGround(const House& house, const WalkColumns& columns, const WalkLimits& limits,
               float ground, ColumnSpots& spots) {
  for (int x = 0; x < columns.size.x; ++x) {
    for (int z = 0; z < columns.size.y; ++z) {
      const std::size_t c = columns.index({x, z});
      const Spot spot = freeAbove(columns.spans[c], ground);
      if (spot.ceiling - spot.floor < limits.head_room) continue;
      const glm::vec2 p = columns.origin + (glm::vec2(x, z) + 0.5f) * columns.pitch;
      const glm::vec3 eye(p.x, ground + limits.eye_height, p.y);
      const CellLocation at = locate(house.graph, house.grid, eye);
      if (at.cell == kExterior && at.in_free_space) insertSpot(spots[c], spot, limits.step_height);
    }
  }
}

void flatten(const ColumnSpots& spots, WalkGrid& grid) {
  grid.first.reserve(spots.size() + 1);
  grid.first.push_back(0);
  for (std::size_t c = 0; c < spots.size(); ++c) {
    for (const Spot& spot : spots[c]) {
      grid.column.push_back(static_cast<std::uint32_t>(c));
      grid.floor.push_back(spot.floor);
      grid.ceiling.push_back(spot.ceiling);
    }
    grid.first.push_back(static_cast<std::uint32_t>(grid.column.size()));
  }
}

// Steps are mutual: where there are several spots to choose from, both must choose each other.
void link(WalkGrid& grid) {
  grid.links.resize(grid.spotCount());
  const auto step = [&](SpotId s, std::size_t d) {
    const glm::ivec2 there =
        grid.columnOf(s) + glm::ivec2(kDirections[2 * d][0], kDirections[2 * d][1]);
    return grid.spotInColumn(s, there, grid.limits.step_height);
  };
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    for (std::size_t d = 0; d < 4; ++d) {
      const SpotId there = step(s, d);
      const bool mutual = there != kNoSpot && step(there, (d + 2) % 4) == s;
      grid.links[s][d] = mutual ? there : kNoSpot;
    }
  }
}

void labelCells(const House& house, DoorsStand doors, WalkGrid& grid) {
  grid.cell_count = house.graph.cells.size();
  grid.joined.assign(grid.cell_count * grid.cell_count, 0);
  for (const Portal& portal : house.graph.portals) {
    const bool known = portal.front < grid.cell_count && portal.back < grid.cell_count;
    const bool open = portal.active || doors == DoorsStand::kAllOpen;
    if (!known || !open) continue;
    grid.joined[portal.front * grid.cell_count + portal.back] = 1;
    grid.joined[portal.back * grid.cell_count + portal.front] = 1;
  }
  grid.cell.assign(grid.spotCount(), kNoCell);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (grid.clearance[s] < kNarrowestClearance) continue;
    grid.cell[s] = locate(house.graph, house.grid, grid.eyeOf(s)).cell;
  }
}

}  // namespace

glm::ivec2 WalkGrid::columnOf(SpotId spot) const noexcept {
  const auto c = static_cast<int>(column[spot]);
  return {c / size.y, c % size.y};
}

glm::ivec2 WalkGrid::columnAt(const glm::vec2& p) const noexcept {
  return glm::ivec2(glm::floor((p - origin) / pitch));
}

glm::vec2 WalkGrid::centerOf(SpotId spot) const noexcept {
  return origin + (glm::vec2(columnOf(spot)) + 0.5f) * pitch;
}

glm::vec3 WalkGrid::eyeOf(SpotId spot) const noexcept {
  const glm::vec2 p = centerOf(spot);
  return {p.x, floor[spot] + limits.eye_height, p.y};
}

SpotId WalkGrid::spotInColumn(SpotId spot, const glm::ivec2& target, float step) const noexcept {
  if (target.x < 0 || target.y < 0 || target.x >= size.x || target.y >= size.y) return kNoSpot;
  const auto c = static_cast<std::size_t>(target.x) * static_cast<std::size_t>(size.y) +
                 static_cast<std::size_t>(target.y);
  SpotId best = kNoSpot;
  float least = step;
  for (SpotId s = first[c]; s < first[c + 1]; ++s) {
    const float rise = std::abs(floor[s] - floor[spot]);
    const float room = std::min(ceiling[s], ceiling[spot]) - std::max(floor[s], floor[spot]);
    if (rise <= least && room >= limits.head_room) {
      best = s;
      least = rise;
    }
  }
  return best;
}

SpotId WalkGrid::neighbour(SpotId spot, int direction) const noexcept {
  const auto straight = [&](SpotId from, int d) {
    return from == kNoSpot ? kNoSpot : links[from][static_cast<std::size_t>((d & 7) / 2)];
  };
  SpotId there = straight(spot, direction);
  if ((direction & 1) != 0) {
    there = straight(straight(spot, direction - 1), direction + 1);
    if (there != straight(straight(spot, direction + 1), direction - 1)) return kNoSpot;
  }
  if (there == kNoSpot || std::abs(floor[there] - floor[spot]) > limits.step_height) return kNoSpot;
  if (!cell.empty() && !mayPass(cell[spot], cell[there])) return kNoSpot;
  return there;
}

WalkGrid buildWalkGrid(const House& house, const WalkColumns& columns, const WalkLimits& limits,
                       DoorsStand doors, float ground) {
  WalkGrid grid;
  grid.limits = limits;
  grid.origin = columns.origin;
  grid.pitch = columns.pitch;
  grid.size = columns.size;
  ColumnSpots spots = standingRoom(columns, limits.head_room);
  if (!std::isnan(ground)) addGround(house, columns, limits, ground, spots);
  GapBridge(columns, limits, spots).run();
  flatten(spots, grid);
  link(grid);
  measureClearance(grid);
  labelCells(house, doors, grid);
  return grid;
}

}  // namespace enfilade
