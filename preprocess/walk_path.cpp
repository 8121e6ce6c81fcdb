#include "preprocess/walk_path.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kBandSpacing = 0.10f;  // [m] of the elastic band's points
constexpr float kFineSpacing = 0.03f;  // [m] of the path's points
constexpr int kBandRounds = 120;       // enough to round a corner over a metre
constexpr float kTension = 0.5f;       // share of the way to the neighbours' middle
constexpr float kPush = 0.02f;         // [m] away from a wall that is close, a round
constexpr float kPushBelow = 0.5f;     // [m] of clearance
constexpr float kPushBelowOutside = 1.2f;
constexpr float kKeep = 0.3f;              // [m] of clearance that is never given up
constexpr float kVisitSlack = 0.4f;        // [m] that a visit may move
constexpr float kInside = 0.25f;           // [m] from the cell's border that a visit stays
constexpr std::size_t kLongestPull = 256;  // spots that one straight piece may replace
constexpr float kPullSlack = 1.002f;       // a straight piece may cost this much more

using Point = WalkPath::Point;

// The greatest index from which `walk` is pulled straight to `from`, at most `limit`.
std::size_t pullFrom(const WalkGrid& grid, const WalkCosts& costs, const TourWalk& walk,
                     std::size_t from, std::size_t limit) {
  std::size_t best = from + 1;
  float cost = 0;
  for (std::size_t to = from + 1; to <= limit; ++to) {
    cost += costOfStep(grid, costs, walk.spots[to - 1], walk.spots[to]);
    if ((to - from) % 4 != 0 && to != limit) continue;
    const StraightWalk straight =
        walkStraight(grid, costs, walk.spots[from], grid.centerOf(walk.spots[from]),
                     grid.centerOf(walk.spots[to]), kNarrowestClearance);
    if (straight.end == walk.spots[to] && straight.cost <= cost * kPullSlack) best = to;
  }
  return best;
}

std::vector<Point> pullStraight(const WalkGrid& grid, const WalkCosts& costs,
                                const TourWalk& walk) {
  std::vector<Point> corners;
  std::size_t visit = 0;
  for (std::size_t i = 0; i < walk.spots.size();) {
    while (visit < walk.visits.size() && walk.visits[visit] < i) ++visit;
    const bool here = visit < walk.visits.size() && walk.visits[visit] == i;
    corners.push_back({grid.centerOf(walk.spots[i]), walk.spots[i], here});
    if (i + 1 == walk.spots.size()) break;
    std::size_t limit = std::min(i + kLongestPull, walk.spots.size() - 1);
    if (here) ++visit;
    if (visit < walk.visits.size()) limit = std::min(limit, walk.visits[visit]);
    i = pullFrom(grid, costs, walk, i, limit);
  }
  return corners;
}

// Points every `spacing` or a little less along straight pieces; the given points stay.
std::vector<Point> resample(const WalkGrid& grid, const std::vector<Point>& points, float spacing) {
  std::vector<Point> out;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point& a = points[i];
    const Point& b = points[i + 1];
    out.push_back(a);
    const int pieces = static_cast<int>(std::ceil(glm::length(b.at - a.at) / spacing));
    for (int k = 1; k < pieces; ++k) {
      const glm::vec2 at = glm::mix(a.at, b.at, static_cast<float>(k) / static_cast<float>(pieces));
      const Point& last = out.back();
      const SpotId spot = walkStraight(grid, {}, last.spot, last.at, at, 0.0f).end;
      if (spot != kNoSpot) out.push_back({at, spot, false});
    }
  }
  if (!points.empty()) out.push_back(points.back());
  return out;
}

// Where clearance grows, as far as the four neighbours tell; not longer than 1.
glm::vec2 uphill(const WalkGrid& grid, SpotId spot) {
  const auto at = [&](int direction) {
    const SpotId s = grid.neighbour(spot, direction);
    return s == kNoSpot ? 0.0f : grid.clearance[s];
  };
  const glm::vec2 slope = glm::vec2(at(0) - at(4), at(2) - at(6)) / (2.0f * grid.pitch);
  const float length = glm::length(slope);
  return length > 1.0f ? slope / length : slope;
}

// Whether a step of kInside in any direction stays in the cell.
bool isWellInside(const WalkGrid& grid, SpotId spot, const glm::vec2& at) {
  for (int d = 0; d < 8; ++d) {
    const glm::vec2 step = glm::normalize(glm::vec2(kDirections[d][0], kDirections[d][1]));
    const SpotId end = walkStraight(grid, {}, spot, at, at + kInside * step, 0.0f).end;
    if (end != kNoSpot && grid.cell[end] != kNoCell && grid.cell[end] != grid.cell[spot]) {
      return false;
    }
  }
  return true;
}

class ElasticBand {
 public:
  ElasticBand(const WalkGrid& grid, const WalkCosts& costs, std::vector<Point>& points)
      : grid_(grid), costs_(costs), points_(points) {
    for (const Point& p : points) anchors_.push_back(p.at);
  }

  void relax(int rounds) {
    for (int round = 0; round < rounds; ++round) {
      for (std::size_t i = 1; i + 1 < points_.size(); ++i) move(i);
    }
  }

 private:
  void move(std::size_t i) {
    const Point& p = points_[i];
    const glm::vec2 middle = 0.5f * (points_[i - 1].at + points_[i + 1].at);
    glm::vec2 to = glm::mix(p.at, middle, kTension);
    const float push_below = grid_.cell[p.spot] == kExterior ? kPushBelowOutside : kPushBelow;
    const float lack = std::max(0.0f, 1.0f - grid_.clearance[p.spot] / push_below);
    to += kPush * lack * uphill(grid_, p.spot);
    if (p.visit) to = heldBack(anchors_[i], to);
    if (!tryMove(i, to)) tryMove(i, glm::mix(p.at, to, 0.25f));
  }

  static glm::vec2 heldBack(const glm::vec2& anchor, const glm::vec2& to) {
    const float length = glm::length(to - anchor);
    return length <= kVisitSlack ? to : anchor + (to - anchor) * (kVisitSlack / length);
  }

  bool tryMove(std::size_t i, const glm::vec2& to) {
    Point& p = points_[i];
    if (glm::length(to - p.at) < 1e-5f) return true;
    const float keep = std::max(kNarrowestClearance, std::min(kKeep, grid_.clearance[p.spot]));
    const SpotId spot = walkStraight(grid_, costs_, p.spot, p.at, to, kNarrowestClearance).end;
    if (spot == kNoSpot || grid_.clearance[spot] < keep) return false;
    if (p.visit && leaves(p, to, spot)) return false;
    if (!joined(points_[i - 1], to, spot) || !joined(points_[i + 1], to, spot)) return false;
    p.at = to;
    p.spot = spot;
    return true;
  }

  // A visit stays a step inside its cell, if it ever was.
  bool leaves(const Point& p, const glm::vec2& to, SpotId spot) const {
    if (grid_.cell[spot] != grid_.cell[p.spot]) return true;
    return isWellInside(grid_, p.spot, p.at) && !isWellInside(grid_, spot, to);
  }

  bool joined(const Point& from, const glm::vec2& to, SpotId spot) const {
    return walkStraight(grid_, costs_, from.spot, from.at, to, kNarrowestClearance).end == spot;
  }

  const WalkGrid& grid_;
  const WalkCosts& costs_;
  std::vector<Point>& points_;
  std::vector<glm::vec2> anchors_;
};

}  // namespace

StraightWalk walkStraight(const WalkGrid& grid, const WalkCosts& costs, SpotId spot,
                          const glm::vec2& from, const glm::vec2& to, float clearance) {
  StraightWalk walk{spot, 0};
  const float length = glm::length(to - from);
  const int steps = std::max(1, static_cast<int>(std::ceil(length / (0.5f * grid.pitch))));
  const float step = length / static_cast<float>(steps);
  for (int i = 1; i <= steps; ++i) {
    const glm::vec2 at = glm::mix(from, to, static_cast<float>(i) / static_cast<float>(steps));
    const glm::ivec2 offset = grid.columnAt(at) - grid.columnOf(walk.end);
    if (offset != glm::ivec2(0)) {
      int direction = 0;
      while (direction < 8 &&
             offset != glm::ivec2(kDirections[direction][0], kDirections[direction][1])) {
        ++direction;
      }
      const SpotId next = direction < 8 ? grid.neighbour(walk.end, direction) : kNoSpot;
      if (next == kNoSpot || grid.clearance[next] < clearance) return {kNoSpot, 0};
      walk.cost += 1.5f * std::abs(grid.floor[next] - grid.floor[walk.end]);
      walk.end = next;
    }
    walk.cost += step * costOfMetre(grid, costs, walk.end);
  }
  return walk;
}

WalkPath smoothWalk(const WalkGrid& grid, const WalkCosts& costs, const TourWalk& walk) {
  std::vector<Point> band = resample(grid, pullStraight(grid, costs, walk), kBandSpacing);
  ElasticBand(grid, costs, band).relax(kBandRounds);
  return {resample(grid, band, kFineSpacing)};
}

}  // namespace enfilade
