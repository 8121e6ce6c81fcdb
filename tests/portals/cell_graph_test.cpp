#include "portals/cell_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "portals/polygon.h"

namespace enfilade {
namespace {

/// Two rooms and the exterior: a door between the rooms and one to the outside.
CellGraph twoRooms() {
  CellGraph graph;
  graph.storeys.push_back({"ground", 0});
  graph.cells.resize(3);
  Portal door;
  door.name = "door";
  door.polygon = {{0, 0, 1}, {0, 0, 0}, {0, 2, 0}, {0, 2, 1}};  // seen from +x
  door.plane = planeOf(door.polygon);
  door.front = 1;
  door.back = 2;
  Portal entrance = door;
  entrance.name = "entrance";
  for (glm::vec3& corner : entrance.polygon) corner.x += 4;
  entrance.plane = planeOf(entrance.polygon);
  entrance.front = kExterior;
  entrance.back = 1;
  graph.portals = {door, entrance};
  linkCells(graph);
  return graph;
}

TEST(CellGraph, PlaneIsPositiveOnTheSideFromWhichThePolygonIsCounterClockwise) {
  const std::vector<glm::vec3> facing_up = {{0, 3, 0}, {0, 3, 2}, {2, 3, 2}, {2, 3, 0}};
  const Plane plane = planeOf(facing_up);
  EXPECT_NEAR(plane.signedDistance({5, 4, 5}), 1.0f, 1e-6f);
  EXPECT_NEAR(plane.signedDistance({-5, 1, 5}), -2.0f, 1e-6f);
}

TEST(CellGraph, PlaneOfAFarAwayPolygonKeepsItsPrecision) {
  const std::vector<glm::vec3> far = {{1000, 3, 2000}, {1000, 3, 2001}, {1001, 3, 2001}};
  for (const glm::vec3& corner : far) EXPECT_NEAR(planeOf(far).signedDistance(corner), 0, 1e-4f);
}

TEST(CellGraph, CenterAndAreaDoNotDependOnWhereCornersStand) {
  Portal portal;
  portal.polygon = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
  EXPECT_FLOAT_EQ(portal.area(), 2.0f);
  EXPECT_NEAR(glm::distance(portal.center(), {1, 0.5f, 0}), 0, 1e-6f);
  portal.polygon.insert(portal.polygon.begin() + 1, {{0.1f, 0, 0}, {0.2f, 0, 0}, {0.3f, 0, 0}});
  EXPECT_FLOAT_EQ(portal.area(), 2.0f);
  EXPECT_NEAR(glm::distance(portal.center(), {1, 0.5f, 0}), 0, 1e-6f);
}

TEST(CellGraph, LinkCellsListsEveryPortalInBothItsCellsInOrder) {
  CellGraph graph = twoRooms();
  linkCells(graph);  // twice gives the same
  EXPECT_EQ(graph.cells[0].portals, (std::vector<PortalId>{1}));
  EXPECT_EQ(graph.cells[1].portals, (std::vector<PortalId>{0, 1}));
  EXPECT_EQ(graph.cells[2].portals, (std::vector<PortalId>{0}));
}

TEST(CellGraph, DiagnoseFindsNothingWrongWithASoundGraph) {
  EXPECT_EQ(diagnose(twoRooms()), std::vector<std::string>{});
}

/// Spoils a sound graph and looks for a line that holds `expected` in what is said of it.
template <typename Spoil>
void expectProblem(const Spoil& spoil, const std::string& expected) {
  CellGraph graph = twoRooms();
  spoil(graph);
  const std::vector<std::string> problems = diagnose(graph);
  EXPECT_TRUE(std::any_of(problems.begin(), problems.end(), [&](const std::string& problem) {
    return problem.find(expected) != std::string::npos;
  })) << expected;
}

TEST(CellGraph, DiagnoseNamesWhatIsWrong) {
  expectProblem([](CellGraph& g) { g.portals[0].back = 17; },
                "portal 0 'door' leads to a cell that does not exist");
  expectProblem([](CellGraph& g) { g.portals[0].back = 1; }, "same cell on both sides");
  expectProblem([](CellGraph& g) { g.portals[0].polygon[2].x += 0.1f; }, "not planar");
  expectProblem([](CellGraph& g) { g.portals[0].polygon[2] = {0, 0.5f, 0.8f}; }, "not convex");
  expectProblem([](CellGraph& g) { g.portals[0].polygon.resize(2); }, "2 corners");
  expectProblem([](CellGraph& g) { g.portals[0].polygon[0].x = NAN; }, "not a finite number");
  expectProblem([](CellGraph& g) { g.cells.emplace_back().name = "attic"; },
                "cell 3 'attic' has no portal");
  expectProblem(
      [](CellGraph& g) {
        for (glm::vec3& corner : g.portals[0].polygon) corner.z = 0;
      },
      "no area");
  expectProblem([](CellGraph& g) { std::swap(g.portals[0].polygon[0], g.portals[0].polygon[2]); },
                "wound against its plane");
}

TEST(Polygon, DistanceIsThatToTheNearestOfManyPointsOnIt) {
  const std::vector<glm::vec3> polygon = {{0, 0, 1}, {0, 0, 0}, {0, 2, 0}, {0, 1.5f, 1}};
  const Plane plane = planeOf(polygon);
  std::mt19937 random(3);
  std::uniform_real_distribution<float> coordinate(-3, 4);
  for (int trial = 0; trial < 50; ++trial) {
    const glm::vec3 p(coordinate(random), coordinate(random), coordinate(random));
    float nearest = 1e9f;
    for (int i = 0; i <= 100; ++i) {
      for (int j = 0; j <= 100; ++j) {
        const float z = static_cast<float>(i) / 100;
        const float y = static_cast<float>(j) / 100 * (2.0f - 0.5f * z);
        nearest = std::min(nearest, glm::distance(p, {0, y, z}));
      }
    }
    EXPECT_NEAR(distanceToPolygon(polygon, plane, p), nearest, 0.02f);
  }
}

TEST(Polygon, SegmentCrossesOnlyThroughThePolygonOrItsGrownRim) {
  const std::vector<glm::vec3> polygon = {{0, 0, 1}, {0, 0, 0}, {0, 2, 0}, {0, 2, 1}};
  const Plane plane = planeOf(polygon);
  EXPECT_TRUE(segmentCrosses(polygon, plane, {-1, 1, 0.5f}, {1, 1, 0.5f}, 0));
  EXPECT_TRUE(segmentCrosses(polygon, plane, {1, 1, 0.5f}, {-1, 1, 0.5f}, 0));
  EXPECT_FALSE(segmentCrosses(polygon, plane, {1, 1, 0.5f}, {0.1f, 1, 0.5f}, 0));
  EXPECT_FALSE(segmentCrosses(polygon, plane, {-1, 1, 1.1f}, {1, 1, 1.1f}, 0));
  EXPECT_TRUE(segmentCrosses(polygon, plane, {-1, 1, 1.1f}, {1, 1, 1.1f}, 0.2f));
  EXPECT_FALSE(segmentCrosses(polygon, plane, {0, -1, 0.5f}, {0, 3, 0.5f}, 1));  // in the plane
}

}  // namespace
}  // namespace enfilade
