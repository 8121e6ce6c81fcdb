#include "preprocess/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "preprocess/tour_check.h"
#include "preprocess/tour_film.h"
#include "preprocess/tour_notes.h"
#include "preprocess/tour_visits.h"
#include "preprocess/walk_house.h"
#include "preprocess/walk_path.h"
#include "scene/error.h"

namespace enfilade {

namespace {

constexpr float kLeastDistance = 0.12f;  // [m] of an eye from anything solid
constexpr int kMostDetours = 4;          // walks tried when something is found in the way

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
  const WalkLimits limits = walkLimitsOf(house, parameters.step_height, parameters.head_room);
  WalkGrid grid = walkGridOf(house, limits, DoorsStand::kAsTheyAre, remarks);
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
