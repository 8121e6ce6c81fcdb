#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "preprocess/obstacle_bins.h"
#include "preprocess/walk_path.h"
#include "preprocess/walk_search.h"
#include "tour_houses.h"
#include "tour_oracles.h"

namespace enfilade {
namespace {

using testing::HouseBuilder;
using testing::twoRooms;

constexpr float kPitch = 0.05f;

WalkColumns columnsOf(const House& house, float pitch) {
  return rasteriseColumns(house, pitch, worldBounds(house.building).grown(pitch));
}

WalkGrid gridOf(const House& house) { return buildWalkGrid(house, columnsOf(house, kPitch), {}); }

SpotId spotAt(const WalkGrid& grid, const glm::vec2& p, float floor) {
  for (SpotId s = 0; s < grid.spotCount(); ++s) {
    if (grid.columnOf(s) == grid.columnAt(p) && std::abs(grid.floor[s] - floor) < 0.05f) return s;
  }
  return kNoSpot;
}

House furnished() {
  HouseBuilder b = twoRooms(0.9f);
  b.solid({1, 0, 1}, {1.5f, 0.9f, 2});
  b.solid({3, 0.7f, 3}, {3.5f, 0.75f, 3.6f});
  b.triangle({6, 0.5f, 3}, {7.1f, 1.3f, 3.3f}, {6.4f, 0.6f, 3.9f});
  return b.build();
}

// From here on the floor or a lintel may be what is nearest.
constexpr double kFloorGap = 0.3;

// The distance from the line above a spot, knee to head, to the nearest triangle.
double gapAround(const House& house, const WalkGrid& grid, SpotId s) {
  double least = 1e9;
  for (float y = grid.limits.step_height + 0.02f; y < grid.limits.head_room; y += 0.04f) {
    const glm::vec2 p = grid.centerOf(s);
    const glm::vec3 at(p.x, grid.floor[s] + y, p.y);
    least = std::min(least, testing::bruteDistance(house, at));
  }
  return least;
}

TEST(WalkColumns, HoldExactHeights) {
  HouseBuilder b;
  b.solid({0, 0.123f, 0}, {1, 0.456f, 1});
  const WalkColumns columns = columnsOf(b.build(), kPitch);
  const glm::ivec2 c = glm::ivec2(glm::floor((glm::vec2(0.5f) - columns.origin) / kPitch));
  const std::vector<SolidSpan>& spans = columns.spans[columns.index(c)];
  ASSERT_EQ(spans.size(), 2u);  // the two faces: a solid is a shell
  EXPECT_NEAR(spans[0].top, 0.123f, 1e-5f);
  EXPECT_NEAR(spans[1].top, 0.456f, 1e-5f);
  EXPECT_FALSE(spans[1].steep);
}

TEST(WalkColumns, TouchEveryColumnThatATriangleTouches) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(0, 3);
  HouseBuilder b;
  std::vector<WorldTriangle> triangles;
  for (int i = 0; i < 40; ++i) {
    WorldTriangle t;
    for (glm::vec3& p : t) p = {anywhere(random), anywhere(random), anywhere(random)};
    triangles.push_back(t);
    b.triangle(t[0], t[1], t[2]);
  }
  const WalkColumns columns = columnsOf(b.build(), 0.1f);
  std::uniform_real_distribution<float> share(0, 1);
  for (int i = 0; i < 20000; ++i) {
    const WorldTriangle& t = triangles[static_cast<std::size_t>(i) % triangles.size()];
    float u = share(random);
    float v = share(random);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const glm::vec3 p = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    const glm::ivec2 c =
        glm::ivec2(glm::floor((glm::vec2(p.x, p.z) - columns.origin) / columns.pitch));
    const auto& spans = columns.spans[columns.index(c)];
    EXPECT_TRUE(std::any_of(spans.begin(), spans.end(), [&](const SolidSpan& span) {
      return span.bottom <= p.y + 1e-3f && p.y <= span.top + 1e-3f;
    }));
  }
}

TEST(WalkGrid, ClearanceIsNeverMoreThanTheTrueGapAndNotMuchLess) {
  const House house = furnished();
  const WalkGrid grid = gridOf(house);
  int compared = 0;
  for (SpotId s = 0; s < grid.spotCount(); s += 17) {
    if (grid.floor[s] != 0 || grid.clearance[s] > 1.4f) continue;
    const glm::vec2 p = grid.centerOf(s);
    if (p.x < 0 || p.x > 8.2f || p.y < 0 || p.y > 4) continue;
    const double gap = gapAround(house, grid, s);
    if (gap < kFloorGap) {
      EXPECT_LE(grid.clearance[s], gap + 0.25 * kPitch) << p.x << " " << p.y;
    }
    EXPECT_GE(grid.clearance[s], gap - 2.2 * kPitch) << p.x << " " << p.y;
    ++compared;
  }
  EXPECT_GT(compared, 300);
}

TEST(WalkGrid, NeighboursAreMutual) {
  const WalkGrid grid = gridOf(furnished());
  for (SpotId s = 0; s < grid.spotCount(); s += 3) {
    for (int d = 0; d < 8; ++d) {
      const SpotId there = grid.neighbour(s, d);
      if (there == kNoSpot) continue;
      EXPECT_EQ(grid.neighbour(there, (d + 4) % 8), s);
    }
  }
}

TEST(WalkGrid, NoStepJoinsCellsWithoutAnOpenPortal) {
  House house = twoRooms(0.9f).build();
  house.graph.portals[0].active = false;
  const WalkGrid grid = gridOf(house);
  WalkSearch search(grid, {});
  const SpotId left = spotAt(grid, {2, 2}, 0);
  const SpotId right = spotAt(grid, {6, 2}, 0);
  ASSERT_NE(left, kNoSpot);
  EXPECT_EQ(search.run(left, [&](SpotId s) { return s == right; }), kNoSpot);
}

TEST(WalkSearch, CostIsTheSumOfItsSteps) {
  const WalkGrid grid = gridOf(furnished());
  const WalkCosts costs;
  WalkSearch search(grid, costs);
  const SpotId goal = spotAt(grid, {7.5f, 0.8f}, 0);
  ASSERT_EQ(search.run(spotAt(grid, {0.6f, 3.2f}, 0), [&](SpotId s) { return s == goal; }), goal);
  const std::vector<SpotId> path = search.pathTo(goal);
  float sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i)
    sum += costOfStep(grid, costs, path[i - 1], path[i]);
  EXPECT_NEAR(search.costTo(goal), sum, 1e-3f * sum);
}

TEST(WalkPath, EveryPointIsAShortStraightWalkFromTheOneBefore) {
  const House house = furnished();
  const WalkGrid grid = gridOf(house);
  const TourWalk walk = walkThrough(house, grid, {}, findGround(house, grid));
  const WalkPath path = smoothWalk(grid, {}, walk);
  float length = 0;
  float before = 0;
  for (std::size_t i = 1; i < walk.spots.size(); ++i) {
    before += glm::length(grid.centerOf(walk.spots[i]) - grid.centerOf(walk.spots[i - 1]));
  }
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const WalkPath::Point& a = path.points[i - 1];
    const WalkPath::Point& b = path.points[i];
    EXPECT_EQ(grid.columnAt(b.at), grid.columnOf(b.spot));
    EXPECT_NE(walkStraight(grid, {}, a.spot, a.at, b.at, kNarrowestClearance).end, kNoSpot);
    length += glm::length(b.at - a.at);
    EXPECT_LT(glm::length(b.at - a.at), 0.1f);
  }
  EXPECT_LT(length, before);
}

TEST(ObstacleBins, AgreeWithTryingEveryTriangle) {
  const House house = furnished();
  const ObstacleBins bins(house);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> x(-0.5f, 9);
  std::uniform_real_distribution<float> y(-0.3f, 3);
  std::uniform_real_distribution<float> z(-0.5f, 4.5f);
  const auto point = [&] { return glm::vec3(x(random), y(random), z(random)); };
  int crossings = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::vec3 p = point();
    const glm::vec3 q = glm::mix(p, point(), 0.2f);
    const double distance = testing::bruteDistance(house, p);
    EXPECT_NEAR(bins.distance(p, 0.7f), std::min(distance, 0.7), 1e-5);
    const bool crosses = testing::bruteCrosses(house, p, q);
    EXPECT_EQ(bins.crosses(p, q), crosses);
    crossings += crosses ? 1 : 0;
  }
  EXPECT_GT(crossings, 100);
}

}  // namespace
}  // namespace enfilade
