#include "preprocess/walk_house.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "preprocess/tour_ground.h"
#include "preprocess/walk_search.h"

namespace enfilade {

namespace {

constexpr float kFinestPitch = 0.05f;      // [m] of a column
constexpr float kMostColumns = 6'000'000;  // more, and the columns get wider
constexpr float kHeadRoomOverEye = 0.2f;   // [m]
constexpr float kGroundAround = 2.5f;      // [m] around the building
constexpr float kLandscape = 8.0f;         // [m] around the rooms
constexpr float kBeforeDoor = 1.0f;        // [m] where ground is looked for
constexpr float kDeepestGround = 1.5f;     // [m] below or above a doorstep
constexpr float kLeastDoorHeight = 1.5f;   // [m]

// Where there is a surface below a point this far before a door, the model has ground outside.
bool hasGround(const WalkColumns& columns, const glm::vec3& p) {
  const auto c = glm::ivec2(glm::floor((glm::vec2(p.x, p.z) - columns.origin) / columns.pitch));
  if (!columns.contains(c)) return false;
  const std::vector<SolidSpan>& spans = columns.spans[columns.index(c)];
  return std::any_of(spans.begin(), spans.end(), [&](const SolidSpan& span) {
    return std::abs(span.top - p.y) <= kDeepestGround;
  });
}

// The lowest step of a `kind` of portal to the exterior with nothing before it; NaN without one.
float missingGround(const House& house, const WalkColumns& columns, PortalKind kind) {
  float ground = std::numeric_limits<float>::quiet_NaN();
  for (const Portal& portal : house.graph.portals) {
    if (portal.front != kExterior && portal.back != kExterior) continue;
    if (portal.kind != kind || std::abs(portal.plane.normal.y) > 0.5f) continue;
    Box bounds;
    for (const glm::vec3& p : portal.polygon) bounds.extend(p);
    if (bounds.size().y < kLeastDoorHeight) continue;
    const float outward = portal.front == kExterior ? kBeforeDoor : -kBeforeDoor;
    glm::vec3 before = portal.center() + outward * portal.plane.normal;
    before.y = bounds.min.y;
    if (hasGround(columns, before)) continue;
    if (std::isnan(ground) || bounds.min.y < ground) ground = bounds.min.y;
  }
  return ground;
}

// The building and some ground around it, but no more of a landscape than lies about the rooms.
Box walkBounds(const House& house) {
  const Box all = worldBounds(house.building).grown(kGroundAround);
  Box rooms;
  for (std::size_t c = kExterior + 1; c < house.graph.cells.size(); ++c) {
    rooms.extend(house.graph.cells[c].bounds);
  }
  if (rooms.empty()) return all;
  rooms = rooms.grown(kLandscape);
  return {glm::max(all.min, rooms.min), glm::min(all.max, rooms.max)};
}

}  // namespace

WalkLimits walkLimitsOf(const House& house, float step_height, float head_room) {
  WalkLimits limits;
  limits.step_height = step_height;
  limits.eye_height = house.eye_height;
  limits.head_room = std::max(head_room, house.eye_height + kHeadRoomOverEye);
  return limits;
}

// Many a model of a building stands on nothing. Then the walk outside is on earth that we add:
// before doors always, before other openings if it leads to more rooms.
WalkGrid walkGridOf(const House& house, const WalkLimits& limits, DoorsStand doors,
                    std::vector<std::string>& notes) {
  const Box bounds = walkBounds(house);
  if (bounds.empty()) return buildWalkGrid(house, {}, limits, doors);
  const float area = bounds.size().x * bounds.size().z;
  const float pitch = std::max(kFinestPitch, std::sqrt(area / kMostColumns));
  const WalkColumns columns = rasteriseColumns(house, pitch, bounds, doors);
  float ground = missingGround(house, columns, PortalKind::kDoor);
  const bool door = !std::isnan(ground);
  if (!door) ground = missingGround(house, columns, PortalKind::kOpening);
  WalkGrid grid = buildWalkGrid(house, columns, limits, doors, ground);
  if (std::isnan(ground)) return grid;
  if (!door) {
    WalkGrid bare = buildWalkGrid(house, columns, limits, doors);
    if (roomsReached(bare) >= roomsReached(grid)) return bare;
  }
  notes.push_back(fmt::format(
      "outside: the model has no ground before a door; the walk has one at y = {:.2f} m", ground));
  return grid;
}

}  // namespace enfilade
