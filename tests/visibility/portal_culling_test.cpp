#include "visibility/portal_culling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "portals/polygon.h"
#include "room_row.h"
#include "test_views.h"

namespace enfilade {
namespace {

using namespace enfilade::testing;

View look(const glm::vec3& eye, const glm::vec3& target) {
  return Camera{.pose = lookAt(eye, target)}.view();
}

const std::vector<ScreenRegion>& regionsOf(const VisibleSet& set, CellId cell) {
  static const std::vector<ScreenRegion> none;
  for (const VisibleCell& visible : set.cells) {
    if (visible.cell == cell) return visible.regions;
  }
  return none;
}

bool sees(const VisibleSet& set, CellId cell) { return !regionsOf(set, cell).empty(); }

bool seesWhole(const View& view, const VisibleSet& set, CellId cell) {
  const auto& regions = regionsOf(set, cell);
  return regions.size() == 1 && contains(regions[0], wholeScreen(view));
}

double areaOf(const ScreenRegion& region) {
  double twice = 0;
  for (std::size_t i = 2; i < region.corners.size(); ++i) {
    const glm::dvec2 a = region.corners[i - 1] - region.corners[0];
    const glm::dvec2 b = region.corners[i] - region.corners[0];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

std::vector<CellId> cellsOf(const VisibleSet& set) {
  std::vector<CellId> cells;
  for (const VisibleCell& cell : set.cells) cells.push_back(cell.cell);
  return cells;
}

TEST(PortalCulling, SeesDownARowOfRoomsThroughTheirDoors) {
  const CellGraph graph = roomRow(5);
  const View view = look({0, 0, -2}, {0, 0, -3});
  const VisibleSet set = cullByPortals(graph, view, 1);
  EXPECT_EQ(set.eye_cell, 1u);
  EXPECT_EQ(cellsOf(set), (std::vector<CellId>{1, 2, 3, 4, 5}));
  EXPECT_TRUE(seesWhole(view, set, 1));
  // Each door is seen smaller than the one before; the door into room 3 is 6 away, 0.5 each way.
  const ScreenRegion& region = regionsOf(set, 3).at(0);
  const float tangent = std::tan(1.047f / 2);
  const float margin = kPortalMargin / 6 / tangent + kScreenSlack + 1e-5f;
  for (const glm::vec2& corner : region.corners) {
    EXPECT_NEAR(std::abs(corner.x), 0.5f / 6 / tangent / 1.25f, margin);
    EXPECT_NEAR(std::abs(corner.y), 1.0f / 6 / tangent, margin);
  }
  ASSERT_EQ(set.portals.size(), 4u);
  for (PortalId id = 0; id < 4; ++id) {
    EXPECT_EQ(set.portals[id].portal, id);
    EXPECT_TRUE(set.portals[id].from_front);
    EXPECT_EQ(set.portals[id].regions.size(), 1u);
  }
}

TEST(PortalCulling, SeesNothingThroughADoorBehindIt) {
  const CellGraph graph = roomRow(3);
  EXPECT_EQ(cellsOf(cullByPortals(graph, look({0, 0, -2}, {0, 0, 5}), 1)),
            (std::vector<CellId>{1}));
  EXPECT_EQ(cellsOf(cullByPortals(graph, look({0, 0, -6}, {0, 0, 5}), 2)),
            (std::vector<CellId>{1, 2}));
}

TEST(PortalCulling, ADoorFarAsideHidesWhatLiesStraightOn) {
  CellGraph graph = roomRow(3);
  for (glm::vec3& corner : graph.portals[1].polygon) corner.x += 30;
  const VisibleSet set = cullByPortals(graph, look({0, 0, -2}, {0, 0, -3}), 1);
  EXPECT_EQ(cellsOf(set), (std::vector<CellId>{1, 2}));
}

TEST(PortalCulling, CameraOnThePortalPlaneStillSeesBothCells) {
  const CellGraph graph = roomRow(2);
  // In the middle, on an edge, in a corner of the door; looking through it, along it, back.
  for (const glm::vec3 eye :
       {glm::vec3(0, 0, -4), glm::vec3(0.5f, 0, -4), glm::vec3(0.5f, 1, -4)}) {
    for (const glm::vec3 way : {glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)}) {
      for (const float off : {0.0f, 1e-7f, -1e-7f, 1e-3f, -1e-3f, 0.1f, -0.1f}) {
        const glm::vec3 at = eye + glm::vec3(0, 0, off);
        const View view = look(at, at + way);
        for (const CellId eye_cell : {1u, 2u}) {
          const VisibleSet set = cullByPortals(graph, view, eye_cell);
          EXPECT_TRUE(seesWhole(view, set, 1));
          EXPECT_TRUE(seesWhole(view, set, 2));
        }
      }
    }
  }
}

TEST(PortalCulling, NothingVanishesWhileTheEyeWalksThroughADoor) {
  // Whatever was seen beyond the door a step before is still seen: the region only grows.
  const CellGraph graph = roomRow(3);
  const glm::vec3 target(0.2f, 0.1f, -20);
  double last = 0;
  for (int step = 0; step <= 400; ++step) {
    const float z = -2.0f - 0.01f * static_cast<float>(step);
    const View view = look({0.1f, 0.1f, z}, target);
    const VisibleSet set = cullByPortals(graph, view, z > -4 ? 1 : 2);
    ASSERT_TRUE(sees(set, 2) && sees(set, 3)) << z;
    const double area = areaOf(regionsOf(set, 2).at(0));
    EXPECT_GE(area, last - 1e-5) << z;
    last = area;
  }
  EXPECT_NEAR(last, 4, 1e-5);
}

TEST(PortalCulling, AnEyeInThePlaneBesideADoorSeesNothingThroughIt) {
  // The room bends around the wall: the eye stands in the door's plane, 2 beside it.
  const CellGraph graph = roomRow(2);
  for (const float off : {0.0f, 1e-6f, -1e-6f, 5e-4f, -5e-4f}) {
    const View view = look({2.5f, 0, -4 + off}, {0, 0, -4});
    const VisibleSet set = cullByPortals(graph, view, 1);
    for (const ScreenRegion& region : regionsOf(set, 2)) EXPECT_LT(areaOf(region), 0.02);
  }
}

TEST(PortalCulling, APortalIsNotPassedTowardsTheEye) {
  // Room 1 bends around room 2 and back: the eye stands behind the door's plane, in room 1.
  const CellGraph graph = roomRow(2);
  const VisibleSet set = cullByPortals(graph, look({0, 0, -9}, {0, 0, 0}), 1);
  EXPECT_EQ(cellsOf(set), (std::vector<CellId>{1}));
}

TEST(PortalCulling, OneWayPortalsAreSeenThroughFromTheFrontOnly) {
  CellGraph graph = roomRow(2);
  graph.portals[0].two_way = false;
  EXPECT_TRUE(sees(cullByPortals(graph, look({0, 0, -2}, {0, 0, -4}), 1), 2));
  EXPECT_FALSE(sees(cullByPortals(graph, look({0, 0, -6}, {0, 0, -4}), 2), 1));
  EXPECT_FALSE(sees(cullByPortals(graph, look({0, 0, -4.05f}, {0, 0, -4}), 2), 1));
}

TEST(PortalCulling, NothingIsSeenThroughAShutPortal) {
  CellGraph graph = roomRow(3);
  graph.portals[1].active = false;
  const VisibleSet set = cullByPortals(graph, look({0, 0, -2}, {0, 0, -4}), 1);
  EXPECT_EQ(cellsOf(set), (std::vector<CellId>{1, 2}));
  EXPECT_EQ(set.portals.size(), 1u);
  EXPECT_FALSE(sees(cullByPortals(graph, look({0, 0, -7.95f}, {0, 0, -9}), 2), 3));
}

TEST(PortalCulling, AShutPortalIsSeenThroughByAnEyeBetweenItAndItsLeaf) {
  CellGraph graph = roomRow(2);
  graph.portals[0].active = false;
  graph.portals[0].seen_within = 0.1f;
  EXPECT_TRUE(sees(cullByPortals(graph, look({0, 0, -3.95f}, {0, 0, -5}), 1), 2));
  EXPECT_FALSE(sees(cullByPortals(graph, look({0, 0, -3.85f}, {0, 0, -5}), 1), 2));
}

TEST(PortalCulling, SeveralPathsIntoOneCellGiveAllTheirRegions) {
  const CellGraph graph =
      graphOf(3, {portalAcrossZ(-4, -2, -1, -1, 1, 1, 2), portalAcrossZ(-4, 1, -1, 2, 1, 1, 2)});
  const VisibleSet set = cullByPortals(graph, look({0, 0, 0}, {0, 0, -4}), 1);
  const auto& regions = regionsOf(set, 2);
  ASSERT_EQ(regions.size(), 2u);
  EXPECT_TRUE(mayBeSeen(regions[0], {{-3, 0, -8}, {-2.9f, 0, -8}}) !=
              mayBeSeen(regions[1], {{-3, 0, -8}, {-2.9f, 0, -8}}));
}

TEST(PortalCulling, AWindowIsSeenThroughADoorAndOnlyThroughIt) {
  // A room behind a door, a wide window in its far wall: outside is seen through both.
  const CellGraph graph = graphOf(3, {portalAcrossZ(-4, -0.5f, -1, 0.5f, 1, 1, 2),
                                      portalAcrossZ(-8, -5, 0, 5, 0.5f, 2, kExterior)});
  const View view = look({0, 0, 0}, {0, 0, -4});
  const VisibleSet set = cullByPortals(graph, view, 1);
  ASSERT_EQ(regionsOf(set, kExterior).size(), 1u);
  const ScreenRegion& region = regionsOf(set, kExterior)[0];
  EXPECT_TRUE(mayBeSeen(region, {{-0.9f, 0.4f, -8.1f}, {-0.9f, 0.4f, -8.1f}}));
  EXPECT_FALSE(mayBeSeen(region, {{-1.2f, 0.4f, -8.1f}, {-1.2f, 0.4f, -8.1f}}));
  EXPECT_FALSE(mayBeSeen(region, {{0, 0.6f, -8.1f}, {0, 0.6f, -8.1f}}));
  EXPECT_FALSE(mayBeSeen(region, {{0, -0.1f, -8.1f}, {0, -0.1f, -8.1f}}));
}

TEST(PortalCulling, PortalsParallelAndCloseTogetherLetTheViewThrough) {
  // A cell 4 cm thick, as between two panes.
  const CellGraph graph = graphOf(4, {portalAcrossZ(-4, -0.5f, -1, 0.5f, 1, 1, 2),
                                      portalAcrossZ(-4.04f, -0.5f, -1, 0.5f, 1, 2, 3)});
  const View far = look({0, 0, 0}, {0, 0, -4});
  EXPECT_TRUE(sees(cullByPortals(graph, far, 1), 3));
  EXPECT_NEAR(areaOf(regionsOf(cullByPortals(graph, far, 1), 3)[0]),
              areaOf(regionsOf(cullByPortals(graph, far, 1), 2)[0]), 0.02);
  for (float z = -3.9f; z > -4.14f; z -= 0.01f) {
    const CellId eye_cell = z > -4 ? 1 : z > -4.04f ? 2 : 3;
    for (const glm::vec3 way : {glm::vec3(0, 0, -1), glm::vec3(1, 0, 0), glm::vec3(0, 0, 1)}) {
      const View view = look({0, 0, z}, glm::vec3(0, 0, z) + way);
      const VisibleSet set = cullByPortals(graph, view, eye_cell);
      EXPECT_TRUE(seesWhole(view, set, 1)) << z;
      EXPECT_TRUE(seesWhole(view, set, 2)) << z;
      EXPECT_TRUE(seesWhole(view, set, 3)) << z;
    }
  }
}

TEST(PortalCulling, ALoopOfRoomsEnds) {
  // Four rooms around a pillar at the origin, a door between every two neighbours.
  const CellGraph graph =
      graphOf(5, {portalAcrossZ(0, 1, -1, 3, 1, 1, 2), portalAcrossX(0, -3, -1, -1, 1, 2, 3),
                  portalAcrossZ(0, -3, -1, -1, 1, 4, 3), portalAcrossX(0, 1, -1, 3, 1, 1, 4)});
  const VisibleSet set = cullByPortals(graph, look({2, 0, 2}, {1, 0, -0.5f}), 1);
  EXPECT_TRUE(sees(set, 2));
  EXPECT_TRUE(sees(set, 3));
}

TEST(PortalCulling, AnImageStandsInPlaceOfWhatLiesBehind) {
  const CellGraph graph = roomRow(4);
  const ShowAsImage beyond_the_second = [](const Portal&, PortalId id, bool) { return id >= 1; };
  const View view = look({0, 0, -2}, {0, 0, -4});
  const VisibleSet set = cullByPortals(graph, view, 1, beyond_the_second);
  EXPECT_EQ(cellsOf(set), (std::vector<CellId>{1, 2}));
  ASSERT_EQ(set.portals.size(), 2u);
  EXPECT_FALSE(set.portals[0].as_image);
  EXPECT_TRUE(set.portals[1].as_image);
  EXPECT_EQ(set.portals[1].regions.size(), 1u);
}

TEST(PortalCulling, AnEyeInAPortalIsNeverShownAnImageThere) {
  const CellGraph graph = roomRow(3);
  const ShowAsImage always = [](const Portal&, PortalId, bool) { return true; };
  const VisibleSet set = cullByPortals(graph, look({0, 0, -3.9f}, {0, 0, -9}), 1, always);
  EXPECT_EQ(cellsOf(set), (std::vector<CellId>{1, 2}));
  EXPECT_FALSE(set.portals[0].as_image);
  EXPECT_TRUE(set.portals.back().as_image);
}

TEST(PortalCulling, BehindAPortalStartsWithItsShadowAndDoesNotLookBack) {
  const CellGraph graph = roomRow(4);
  const View view = look({0.3f, 0.2f, -2}, {0, 0, -4});
  const VisibleSet set = cullBehindPortal(graph, view, 0, true);
  EXPECT_EQ(set.eye_cell, kNoCell);
  EXPECT_EQ(cellsOf(set), (std::vector<CellId>{2, 3, 4}));
  const Portal& door = graph.portals[0];
  const ScreenRegion shadow =
      clipRegion(view, wholeScreen(view), grownPolygon(door.polygon, door.plane, kPortalMargin));
  ASSERT_EQ(regionsOf(set, 2).size(), 1u);
  EXPECT_TRUE(contains(regionsOf(set, 2)[0], shadow));
  EXPECT_TRUE(contains(shadow, regionsOf(set, 2)[0]));
  EXPECT_EQ(cellsOf(cullBehindPortal(graph, look({0, 0, -10}, {0, 0, 0}), 1, false)),
            (std::vector<CellId>{1, 2}));
}

TEST(PortalCulling, CourtyardsWithHundredsOfWindowsStayConservative) {
  // Two facades of 12 × 12 windows each, one behind the other: thousands of paths into room 3.
  std::vector<Portal> windows;
  for (int x = 0; x < 12; ++x) {
    for (int y = 0; y < 12; ++y) {
      const float u = static_cast<float>(x);
      const float v = static_cast<float>(y);
      windows.push_back(portalAcrossZ(-4, u - 6, v - 6, u - 5.4f, v - 5.4f, 1, 2));
      windows.push_back(portalAcrossZ(-9, u - 6, v - 6, u - 5.4f, v - 5.4f, 2, 3));
    }
  }
  const CellGraph graph = graphOf(4, std::move(windows));
  const glm::vec3 eye(0.3f, 0.1f, 0);
  const View view = look(eye, {0, 0, -4});
  const VisibleSet set = cullByPortals(graph, view, 1);
  EXPECT_LE(regionsOf(set, 2).size(), 64u);
  EXPECT_LE(regionsOf(set, 3).size(), 64u);
  std::mt19937 random(1);
  int seen = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::vec3 p(uniform(random, -9, 9), uniform(random, -9, 9), uniform(random, -12, -5));
    const auto passes = [&](float z) {
      return std::any_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& portal) {
        return portal.polygon[0].z == z && segmentCrosses(portal.polygon, portal.plane, eye, p, 0);
      });
    };
    const auto at = onScreen(view, p);
    if (!at || !passes(-4) || (p.z < -9 && !passes(-9))) continue;
    ++seen;
    const auto& regions = regionsOf(set, p.z < -9 ? 3 : 2);
    EXPECT_TRUE(std::any_of(regions.begin(), regions.end(),
                            [&](const auto& region) { return depthInside(region, *at) >= 0; }));
  }
  EXPECT_GT(seen, 500);
}

}  // namespace
}  // namespace enfilade
