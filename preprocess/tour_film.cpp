#include "preprocess/tour_film.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace enfilade {

namespace {

constexpr float kSpacing = 0.03f;        // [m] between moments
constexpr float kFloorBlur = 0.35f;      // [m] of way: stairs become a slope
constexpr float kLessFloorBlur = 0.08f;  // [m] where the ceiling is low
constexpr float kEyeRoom = 0.2f;         // [m] kept around the eye
constexpr float kTurnBlur = 0.55f;       // [m] of way over which a turn is spread
constexpr float kSlopeBlur = 0.8f;       // [m] of way
constexpr float kLookAhead = 0.4f;       // [m] that the view is ahead of the way
constexpr float kAboutTurn = 2.6f;       // [rad] a sharper turn goes by the more open side
constexpr float kPan = 0.6f;             // [rad] to either side when a room is walked through
constexpr float kShortPassage = 2.0f;    // [m] shorter ones are not looked around in
constexpr float kLongPassage = 5.0f;     // [m] from here on the pan is full
constexpr float kUnhurried = 0.12f;      // [m] of way a frame
constexpr float kSlopeShare = 0.5f;      // of a slope's angle that the view follows
constexpr float kMostPitch = 0.2f;       // [rad]
constexpr float kRestingPitch = -0.03f;  // [rad] a walker looks a little down

// A Gaussian blur of evenly spaced values, the ends held.
std::vector<float> blur(const std::vector<float>& values, float sigma) {
  const int reach = static_cast<int>(3.0f * sigma / kSpacing);
  std::vector<double> weights;
  for (int k = 0; k <= reach; ++k) {
    const double x = static_cast<double>(k) * kSpacing / std::max(sigma, 1e-6f);
    weights.push_back(std::exp(-0.5 * x * x));
  }
  const int count = static_cast<int>(values.size());
  std::vector<float> out(values.size());
  for (int i = 0; i < count; ++i) {
    double sum = 0;
    double total = 0;
    for (int k = -reach; k <= reach; ++k) {
      const double weight = weights[static_cast<std::size_t>(std::abs(k))];
      sum += weight * values[static_cast<std::size_t>(std::clamp(i + k, 0, count - 1))];
      total += weight;
    }
    out[static_cast<std::size_t>(i)] = static_cast<float>(sum / total);
  }
  return out;
}

float wrapped(float angle) { return std::remainder(angle, glm::two_pi<float>()); }

// Yaw 0 looks down −Z and positive turns left.
float yawOf(const glm::vec2& direction) { return std::atan2(-direction.x, -direction.y); }
glm::vec2 directionOf(float yaw) { return {-std::sin(yaw), -std::cos(yaw)}; }

struct Moment {
  glm::vec2 at{0};
  float floor = 0;
  SpotId spot = kNoSpot;
  bool visit = false;
};

// Moments every kSpacing along the path.
std::vector<Moment> evenMoments(const WalkGrid& grid, const WalkPath& path) {
  std::vector<Moment> out;
  float carried = 0;  // way since the last moment
  bool visit = false;
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const WalkPath::Point& b = path.points[i];
    visit = visit || b.visit;
    if (i == 0 || i + 1 == path.points.size()) {
      out.push_back({b.at, grid.floor[b.spot], b.spot, visit});
      visit = false;
      continue;
    }
    const WalkPath::Point& a = path.points[i - 1];
    carried += glm::length(b.at - a.at);
    if (carried < kSpacing) continue;
    carried = 0;
    out.push_back({b.at, grid.floor[b.spot], b.spot, visit});
    visit = false;
  }
  return out;
}

// How far one can walk from `spot` along `direction`, at most 4 m.
float openness(const WalkGrid& grid, const Moment& from, const glm::vec2& direction) {
  float reached = 0;
  for (float d = 0.25f; d <= 4.0f; d += 0.25f) {
    const StraightWalk walk =
        walkStraight(grid, {}, from.spot, from.at, from.at + d * direction, 0.0f);
    if (walk.end == kNoSpot) break;
    reached = d;
  }
  return reached;
}

// The direction of the way at each moment, turns counted.
std::vector<float> headings(const WalkGrid& grid, const std::vector<Moment>& moments) {
  std::vector<float> yaws(moments.size(), 0.0f);
  const std::size_t last = moments.size() - 1;
  bool started = false;
  for (std::size_t i = 0; i <= last; ++i) {
    const glm::vec2 way = moments[std::min(i + 2, last)].at - moments[i < 2 ? 0 : i - 2].at;
    const float before = i > 0 ? yaws[i - 1] : 0.0f;
    yaws[i] = before;
    if (glm::length(way) < 0.3f * kSpacing) continue;
    float turn = wrapped(yawOf(way) - before);
    if (started && std::abs(turn) > kAboutTurn) {
      const float side = before + std::copysign(0.5f * glm::pi<float>(), turn);
      const bool other = openness(grid, moments[i], -directionOf(side)) >
                         openness(grid, moments[i], directionOf(side));
      if (other) turn -= std::copysign(glm::two_pi<float>(), turn);
    }
    if (!started) std::fill(yaws.begin(), yaws.begin() + static_cast<std::ptrdiff_t>(i), turn);
    yaws[i] = before + turn;
    started = true;
  }
  return yaws;
}

// Looks to one side, then to the other, along each passage through a cell.
std::vector<float> pans(const WalkGrid& grid, const std::vector<Moment>& moments,
                        const std::vector<float>& yaws, float hurry) {
  std::vector<float> pan(moments.size(), 0.0f);
  const float unhurried = std::clamp(kUnhurried / std::max(hurry, 1e-6f), 0.3f, 1.0f);
  for (std::size_t begin = 0; begin < moments.size();) {
    std::size_t end = begin;
    const CellId cell = grid.cell[moments[begin].spot];
    while (end < moments.size() && grid.cell[moments[end].spot] == cell) ++end;
    const float length = static_cast<float>(end - begin) * kSpacing;
    if (length > kShortPassage) {
      const float share = (length - kShortPassage) / (kLongPassage - kShortPassage);
      const std::size_t middle = begin + (end - begin) / 4;
      const glm::vec2 left = directionOf(yaws[middle] + 0.5f * glm::pi<float>());
      const bool left_first =
          openness(grid, moments[middle], left) >= openness(grid, moments[middle], -left);
      const float amplitude = (left_first ? kPan : -kPan) * std::min(share, 1.0f) * unhurried;
      for (std::size_t i = begin; i < end; ++i) {
        const float u = (static_cast<float>(i - begin) + 0.5f) / static_cast<float>(end - begin);
        const float window = std::sin(glm::pi<float>() * u);
        pan[i] = amplitude * window * std::sin(glm::two_pi<float>() * u);
      }
    }
    begin = end;
  }
  return pan;
}

// The eye's height over a smoothed floor, less smoothed where it would come near something.
std::vector<float> eyeHeights(const WalkGrid& grid, const ObstacleBins& obstacles,
                              const std::vector<Moment>& moments) {
  std::vector<float> floor;
  for (const Moment& m : moments) floor.push_back(m.floor);
  const std::vector<float> close = blur(floor, kLessFloorBlur);
  std::vector<float> smooth = blur(floor, kFloorBlur);
  std::vector<float> near(moments.size(), 0.0f);
  bool any = false;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const auto distance = [&](float y) {
      const glm::vec3 eye(moments[i].at.x, y + grid.limits.eye_height, moments[i].at.y);
      return obstacles.distance(eye, kEyeRoom);
    };
    const bool nearer = distance(smooth[i]) < distance(close[i]);
    near[i] = nearer ? 1.0f : 0.0f;
    any = any || nearer;
  }
  if (any) near = blur(near, kFloorBlur);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    const float share = std::min(1.0f, 4.0f * near[i]);
    smooth[i] = glm::mix(smooth[i], close[i], share) + grid.limits.eye_height;
  }
  return smooth;
}

}  // namespace

std::vector<TourSample> filmWalk(const WalkGrid& grid, const ObstacleBins& obstacles,
                                 const WalkPath& path, int frames) {
  const std::vector<Moment> moments = evenMoments(grid, path);
  if (moments.empty()) return {};
  const float hurry =
      static_cast<float>(moments.size()) * kSpacing / static_cast<float>(std::max(frames, 1));
  const std::vector<float> heights = eyeHeights(grid, obstacles, moments);
  const std::vector<float> heading = headings(grid, moments);
  const std::vector<float> turns = blur(heading, kTurnBlur + 2.0f * hurry);
  const std::vector<float> pan = blur(pans(grid, moments, turns, hurry), 0.2f);
  std::vector<float> climb(moments.size(), 0.0f);
  for (std::size_t i = 1; i < moments.size(); ++i) {
    climb[i] = std::atan((heights[i] - heights[i - 1]) / kSpacing);
  }
  climb = blur(climb, kSlopeBlur);

  std::vector<TourSample> samples(moments.size());
  const auto ahead = static_cast<std::size_t>(kLookAhead / kSpacing);
  for (std::size_t i = 0; i < moments.size(); ++i) {
    TourSample& s = samples[i];
    s.eye = {moments[i].at.x, heights[i], moments[i].at.y};
    s.yaw = turns[std::min(i + ahead, moments.size() - 1)] + pan[i];
    s.pitch = kRestingPitch + std::clamp(kSlopeShare * climb[i], -kMostPitch, kMostPitch);
    s.cell = grid.cell[moments[i].spot];
    s.visit = moments[i].visit;
    if (i == 0) continue;
    const double walked = glm::length(s.eye - samples[i - 1].eye);
    const double turned = kMetresPerTurn * (s.yaw - samples[i - 1].yaw);
    s.effort = samples[i - 1].effort + std::sqrt(walked * walked + turned * turned);
  }
  return samples;
}

}  // namespace enfilade
