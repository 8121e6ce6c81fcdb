#include "preprocess/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "preprocess/tour_check.h"
#include "preprocess/tour_film.h"
#include "preprocess/tour_notes.h"
#include "preprocess/tour_visits.h"
#include "preprocess/walk_path.h"
#include "scene/error.h"

namespace enfilade {

namespace {

constexpr float kFinestPitch = 0.05f;      // [m] of a column
constexpr float kMostColumns = 6'000'000;  // more, and the columns get wider
constexpr float kHeadRoomOverEye = 0.2f;   // [m]
constexpr float kLeastDistance = 0.12f;    // [m] of an eye from anything solid
constexpr float kGroundAround = 2.5f;      // [m] around the building
constexpr float kLandscape = 8.0f;         // [m] around the rooms
constexpr float kBeforeDoor = 1.0f;        // [m] where ground is looked for
constexpr float kDeepestGround = 1.5f;     // [m] below or above a doorstep
constexpr float kLeastDoorHeight = 1.5f;   // [m]
constexpr int kMostDetours = 4;            // walks tried when something is found in the way

void check(const House& house, const TourParameters& parameters) {
  const auto reject = [](const char* reason) { throw Error(ErrorKind::kUsage, "tour", reason); };
  if (parameters.frames < 2 || parameters.frames > 1'000'000) {
    reject("the number of frames must be 2 to 1000000");
  }
  if (!(parameters.body_radius > 0)) reject("the body's radius must be more than 0 m");
  if (!(parameters.step_height > 0)) reject("the step height must be more than 0 m");
  if (!(parameters.head_room > 0)) reject("the head room must be more than 0 m");
  if (worldBounds(house.building).empty()) {
    throw Error(ErrorKind::kBadInput, house.info.model_name, "has no geometry to walk on");
  }
}

WalkLimits limitsOf(const House& house, const TourParameters& parameters) {
  WalkLimits limits;
  limits.step_height = parameters.step_height;
  limits.eye_height = house.eye_height;
  limits.head_room = std::max(parameters.head_room, house.eye_height + kHeadRoomOverEye);
  return limits;
}

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

std::ptrdiff_t roomsReached(const House& house, const WalkGrid& grid) {
  const TourGround ground = findGround(house, grid);
  return std::count_if(ground.target.begin() + 1, ground.target.end(),
                       [](SpotId target) { return target != kNoSpot; });
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

// Many a model of a building stands on nothing. Then the walk outside is on earth that we add:
// before doors always, before other openings if it leads to more rooms.
WalkGrid makeGrid(const House& house, const TourParameters& parameters,
                  std::vector<std::string>& notes) {
  const Box bounds = walkBounds(house);
  const float area = bounds.size().x * bounds.size().z;
  const float pitch = std::max(kFinestPitch, std::sqrt(area / kMostColumns));
  const WalkColumns columns = rasteriseColumns(house, pitch, bounds);
  const WalkLimits limits = limitsOf(house, parameters);
  float ground = missingGround(house, columns, PortalKind::kDoor);
  const bool door = !std::isnan(ground);
  if (!door) ground = missingGround(house, columns, PortalKind::kOpening);
  WalkGrid grid = buildWalkGrid(house, columns, limits, ground);
  if (std::isnan(ground)) return grid;
  if (!door) {
    WalkGrid bare = buildWalkGrid(house, columns, limits);
    if (roomsReached(house, bare) >= roomsReached(house, grid)) return bare;
  }
  notes.push_back(fmt::format(
      "outside: the model has no ground before a door; the walk has one at y = {:.2f} m", ground));
  return grid;
}

// A line for each cell that could be reached but that the frames do not show.
void noteMissed(const House& house, const TourGround& ground, const Tour& tour,
                std::vector<std::string>& notes) {
  for (CellId cell = 0; cell < ground.target.size(); ++cell) {
    if (ground.target[cell] == kNoSpot) continue;
    if (std::binary_search(tour.visited.begin(), tour.visited.end(), cell)) continue;
    notes.push_back(fmt::format("not visited: {}: {} frames are too few",
                                house.graph.cells[cell].name, tour.path.poses.size()));
  }
}

// No walk goes here again: the eye came too near to something that the grid does not show.
void close(WalkGrid& grid, const glm::vec3& eye) {
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (glm::length(grid.eyeOf(s) - eye) < 2.0f * grid.pitch) grid.clearance[s] = 0;
  }
}

}  // namespace

Tour makeTour(const House& house, const TourParameters& parameters) {
  check(house, parameters);
  std::vector<std::string> remarks;
  WalkGrid grid = makeGrid(house, parameters, remarks);
  const ObstacleBins obstacles(house);
  WalkCosts costs;
  costs.body_radius = parameters.body_radius;
  costs.comfort = std::max(costs.comfort, 1.5f * parameters.body_radius);
  Tour tour;
  for (int attempt = 0;; ++attempt) {
    const TourGround ground = findGround(house, grid);
    const TourWalk walk = walkThrough(house, grid, costs, ground);
    const std::vector<TourSample> samples =
        filmWalk(grid, obstacles, smoothWalk(grid, costs, walk), parameters.frames);
    tour.path.poses = chooseFrames(samples, obstacles, parameters.frames);
    tour.visited = cellsAlong(house, tour.path);
    const std::vector<TourViolation> violations =
        checkTour(house, obstacles, tour.path, kLeastDistance);
    if (violations.empty() || attempt == kMostDetours) {
      tour.notes = remarks;
      explainWalk(house, grid, ground, walk, parameters.body_radius, tour.notes);
      noteMissed(house, ground, tour, tour.notes);
      for (const TourViolation& v : violations) {
        tour.notes.push_back(fmt::format("pose {}: {}", v.pose, v.what));
      }
      break;
    }
    for (const TourViolation& v : violations) close(grid, tour.path.poses[v.pose].pose.position);
  }
  tour.path.name = house.info.model_name.empty() ? "tour" : "tour of " + house.info.model_name;
  return tour;
}

}  // namespace enfilade
