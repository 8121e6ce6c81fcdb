#include "app/cell_spots.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "preprocess/tour_entrance.h"

namespace enfilade {

namespace {

constexpr float kFloorShare = 0.25f;   // of the spots of the cell's largest part
constexpr float kTooNear = 1.2f;       // [m] a portal this near shows little
constexpr float kEntranceNear = 8.0f;  // [m] from the place outside
constexpr float kFarOutside = 0.1f;    // [1/m] of clearance given up to be near the building
constexpr int kTries = 8;              // places looked at along each side of a cell

float yawToward(const glm::vec3& eye, const glm::vec3& target) {
  return std::atan2(eye.x - target.x, eye.z - target.z);
}

float planDistance(const glm::vec3& a, const glm::vec3& b) {
  return glm::length(glm::vec2(a.x - b.x, a.z - b.z));
}

bool isUpright(const Portal& portal) { return std::abs(portal.plane.normal.y) < 0.5f; }

// The centre of the largest upright portal of `cell` beyond arm's length, or nothing.
const Portal* largestPortal(const House& house, const Cell& cell, const glm::vec3& eye) {
  const Portal* best = nullptr;
  for (const PortalId id : cell.portals) {
    const Portal& portal = house.graph.portals[id];
    if (!isUpright(portal) || planDistance(portal.center(), eye) < kTooNear) continue;
    if (best == nullptr || portal.area() > best->area()) best = &portal;
  }
  return best;
}

// Along the longer side, toward its farther end.
float yawAlong(const Box& box, const glm::vec3& eye) {
  const glm::vec3 size = box.size();
  glm::vec3 target = eye;
  const int axis = size.x > size.z ? 0 : 2;
  target[axis] = eye[axis] < box.center()[axis] ? box.max[axis] : box.min[axis];
  return box.empty() ? 0.0f : yawToward(eye, target);
}

// Toward the nearest door, or else the middle of the building.
float yawFromOutside(const House& house, const glm::vec3& eye, const Box& building) {
  glm::vec3 target = building.empty() ? eye : building.center();
  float least = kEntranceNear;
  for (const PortalId id : house.graph.cells[kExterior].portals) {
    const Portal& portal = house.graph.portals[id];
    const float distance = glm::length(portal.center() - eye);
    if (portal.kind == PortalKind::kWindow || !isUpright(portal) || distance >= least) continue;
    least = distance;
    target = portal.center();
  }
  return yawToward(eye, target);
}

// A point of the cell's free space, by its middle.
glm::vec3 middleOf(const House& house, CellId cell) {
  const Box& box = house.graph.cells[cell].bounds;
  if (box.empty()) return glm::vec3(0);
  const glm::vec3 middle = box.center();
  glm::vec3 best = middle;
  float least = std::numeric_limits<float>::infinity();
  for (int i = 0; i < kTries * kTries * kTries; ++i) {
    const glm::ivec3 at(i % kTries, i / kTries % kTries, i / (kTries * kTries));
    const glm::vec3 p = box.min + (glm::vec3(at) + 0.5f) / float(kTries) * box.size();
    const float distance = glm::length(p - middle);
    if (distance >= least) continue;
    const CellLocation where = locate(house.graph, house.grid, p);
    if (where.cell != cell || !where.in_free_space) continue;
    least = distance;
    best = p;
  }
  return best;
}

// Where there is no entrance: the roomiest place that is not far from the building's middle.
SpotId roomiestOutside(const WalkGrid& grid, const Box& building,
                       std::span<const std::uint8_t> on_floor) {
  SpotId best = kNoSpot;
  float most = 0;
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (on_floor[s] == 0 || grid.cell[s] != kExterior) continue;
    const float score =
        grid.clearance[s] - kFarOutside * planDistance(grid.eyeOf(s), building.center());
    if (best != kNoSpot && score <= most) continue;
    best = s;
    most = score;
  }
  return best;
}

// Away from the building, whose front is taken to be its +z side.
glm::vec3 viewpointOutside(const Box& building) {
  if (building.empty()) return glm::vec3(0);
  return building.center() + glm::vec3(0, 0, 0.75f * building.size().z + 3.0f);
}

CellSpot spotOutside(const House& house, const WalkGrid& grid, const TourGround& ground,
                     std::span<const std::uint8_t> on_floor) {
  const Box building = worldBounds(house.building);
  CellSpot outside;
  if (ground.part >= 0) outside.spot = placeOutside(house, grid, ground);
  if (outside.spot == kNoSpot) outside.spot = roomiestOutside(grid, building, on_floor);
  outside.eye = outside.spot == kNoSpot ? viewpointOutside(building) : grid.eyeOf(outside.spot);
  outside.yaw = yawFromOutside(house, outside.eye, building);
  return outside;
}

}  // namespace

std::vector<std::uint8_t> floorSpots(const WalkGrid& grid, const std::vector<int>& parts) {
  std::map<std::pair<CellId, int>, std::size_t> counts;
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (parts[s] >= 0) ++counts[{grid.cell[s], parts[s]}];
  }
  std::map<CellId, std::size_t> most;
  for (const auto& [key, count] : counts) most[key.first] = std::max(most[key.first], count);
  std::vector<std::uint8_t> on_floor(grid.spotCount(), 0);
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (parts[s] < 0) continue;
    const auto count = static_cast<float>(counts[{grid.cell[s], parts[s]}]);
    on_floor[s] = count >= kFloorShare * static_cast<float>(most[grid.cell[s]]);
  }
  return on_floor;
}

std::vector<CellSpot> cellSpots(const House& house, const WalkGrid& grid, const TourGround& ground,
                                std::span<const std::uint8_t> on_floor) {
  const std::vector<SpotId> best = bestSpots(grid, [&](SpotId s) { return on_floor[s] != 0; });
  std::vector<CellSpot> spots{spotOutside(house, grid, ground, on_floor)};
  for (CellId cell = kExterior + 1; cell < house.graph.cells.size(); ++cell) {
    const Cell& room = house.graph.cells[cell];
    CellSpot& spot = spots.emplace_back();
    spot.spot = best[cell];
    spot.eye = spot.spot == kNoSpot ? middleOf(house, cell) : grid.eyeOf(spot.spot);
    const Portal* portal = largestPortal(house, room, spot.eye);
    spot.yaw =
        portal != nullptr ? yawToward(spot.eye, portal->center()) : yawAlong(room.bounds, spot.eye);
  }
  return spots;
}

CellId startCellOf(const House& house, const TourGround& ground, std::span<const CellSpot> spots) {
  if (spots.empty()) return kExterior;
  const SpotId outside = spots[kExterior].spot;
  if (outside != kNoSpot && ground.holds(outside)) return kExterior;
  CellId best = kExterior;
  for (CellId cell = kExterior + 1; cell < spots.size(); ++cell) {
    if (spots[cell].spot == kNoSpot) continue;
    const float area = house.graph.cells[cell].floor_area;
    if (best == kExterior || area > house.graph.cells[best].floor_area) best = cell;
  }
  return best;
}

}  // namespace enfilade
