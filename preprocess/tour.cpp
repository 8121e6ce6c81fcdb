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

WalkGrid makeGrid(const House& house, const TourParameters& parameters) {
  const glm::vec3 size = worldBounds(house.building).size();
  const float pitch = std::max(kFinestPitch, std::sqrt(size.x * size.z / kMostColumns));
  WalkLimits limits;
  limits.step_height = parameters.step_height;
  limits.eye_height = house.eye_height;
  limits.head_room = std::max(parameters.head_room, house.eye_height + kHeadRoomOverEye);
  return buildWalkGrid(house, rasteriseColumns(house, pitch, pitch), limits);
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
  WalkGrid grid = makeGrid(house, parameters);
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
    tour.notes = explainWalk(house, grid, ground, walk, parameters.body_radius);
    const std::vector<TourViolation> violations =
        checkTour(house, obstacles, tour.path, kLeastDistance);
    if (violations.empty()) break;
    if (attempt == kMostDetours) {
      for (const TourViolation& v : violations) {
        tour.notes.push_back(fmt::format("pose {}: {}", v.pose, v.what));
      }
      break;
    }
    for (const TourViolation& v : violations) {
      close(grid, tour.path.poses[v.pose].pose.position);
    }
  }
  tour.path.name = house.info.model_name.empty() ? "tour" : "tour of " + house.info.model_name;
  tour.visited = cellsAlong(house, tour.path);
  return tour;
}

}  // namespace enfilade
