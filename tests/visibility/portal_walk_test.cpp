#include "visibility/portal_walk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "box_house.h"
#include "room_row.h"

namespace enfilade {
namespace {

using namespace enfilade::testing;

constexpr float kForever = std::numeric_limits<float>::infinity();

TEST(PortalWalk, CrossesThePortalsOnTheWayUpToTheDistance) {
  const CellGraph graph = roomRow(4);  // doors at z = -4, -8, -12
  const PortalWalker walker(graph);
  std::vector<PortalCrossing> crossings;
  EXPECT_EQ(walker.walk(1, {0, 0, -2}, {0, 0, -1}, 1.9f, crossings), 1u);
  EXPECT_TRUE(crossings.empty());
  EXPECT_EQ(walker.walk(1, {0, 0, -2}, {0, 0, -1}, 6.1f, crossings), 3u);
  ASSERT_EQ(crossings.size(), 2u);
  EXPECT_EQ(crossings[1].portal, 1u);
  EXPECT_TRUE(crossings[1].from_front);
  EXPECT_FLOAT_EQ(crossings[1].distance, 6);
  EXPECT_EQ(walker.walk(1, {0, 0, -2}, {0, 0, -1}, kForever, crossings), 4u);
  EXPECT_EQ(walker.walk(4, {0, 0, -14}, {0, 0, 1}, kForever, crossings), 1u);
  ASSERT_EQ(crossings.size(), 3u);
  EXPECT_FALSE(crossings[0].from_front);
}

TEST(PortalWalk, ASurfaceInThePlaneOfAPortalLiesOnTheNearSide) {
  const CellGraph graph = roomRow(2);
  std::vector<PortalCrossing> crossings;
  EXPECT_EQ(PortalWalker(graph).walk(1, {0, 0, -2}, {0, 0, -1}, 2, crossings), 1u);
}

TEST(PortalWalk, TheToleranceWidensThePolygonAndTheStart) {
  const CellGraph graph = roomRow(2);
  const PortalWalker walker(graph, 0.05f);
  std::vector<PortalCrossing> crossings;
  EXPECT_EQ(walker.walk(1, {0.54f, 0, -2}, {0, 0, -1}, 9, crossings), 2u);
  EXPECT_EQ(walker.walk(1, {0.56f, 0, -2}, {0, 0, -1}, 9, crossings), 1u);
  EXPECT_EQ(walker.walk(1, {0, 0, -4.04f}, {0, 0, -1}, 9, crossings), 2u);
  EXPECT_EQ(walker.walk(1, {0, 0, -4.06f}, {0, 0, -1}, 9, crossings), 1u);
}

TEST(PortalWalk, EndsInAGraphThatContradictsItself) {
  // The same doorway twice: from room 1 into room 2, and from room 2 into room 1.
  const CellGraph graph =
      graphOf(3, {portalAcrossZ(-4, -1, -1, 1, 1, 1, 2), portalAcrossZ(-4, -1, -1, 1, 1, 2, 1)});
  std::vector<PortalCrossing> crossings;
  PortalWalker(graph).walk(1, {0, 0, 0}, {0, 0, -1}, 9, crossings);
  EXPECT_LE(crossings.size(), 2u);
}

/// Whether a segment passes so near to a portal's rim that the tolerance decides.
bool grazesARim(const CellGraph& graph, const glm::vec3& a, const glm::vec3& b, float tolerance) {
  return std::any_of(graph.portals.begin(), graph.portals.end(), [&](const Portal& portal) {
    const float da = portal.plane.signedDistance(a);
    const float db = portal.plane.signedDistance(b);
    if (std::min(std::abs(da), std::abs(db)) > tolerance && da * db > 0) return false;
    const glm::vec3 hit = da == db ? a : a + std::clamp(da / (da - db), 0.0f, 1.0f) * (b - a);
    for (std::size_t i = 0; i < portal.polygon.size(); ++i) {
      const glm::vec3& corner = portal.polygon[i];
      const glm::vec3 edge = portal.polygon[(i + 1) % portal.polygon.size()] - corner;
      const float t = std::clamp(glm::dot(hit - corner, edge) / glm::dot(edge, edge), 0.0f, 1.0f);
      if (glm::distance(hit, corner + t * edge) < tolerance) return true;
    }
    return false;
  });
}

TEST(PortalWalk, InHousesOfBoxesItEndsInThePointsOwnCell) {
  std::mt19937 random(6);
  int with_portals = 0;
  std::vector<PortalCrossing> crossings;
  for (unsigned seed = 300; seed < 340; ++seed) {
    const BoxHouse house(seed, {});
    const PortalWalker walker(house.graph());
    for (int i = 0; i < 10000; ++i) {
      const glm::vec3 a =
          i % 4 == 0 ? pointAtAnOpening(random, house) : randomPoint(random, house, 2);
      const glm::vec3 b = randomPoint(random, house, 2);
      if (!house.sees(a, b) || grazesARim(house.graph(), a, b, 0.03f)) continue;
      const float distance = glm::distance(a, b);
      const CellId end = walker.walk(house.cellAt(a), a, (b - a) / distance, distance, crossings);
      ASSERT_EQ(end, house.cellAt(b));
      with_portals += !crossings.empty();
      CellId cell = house.cellAt(a);
      for (std::size_t c = 0; c < crossings.size(); ++c) {
        const Portal& portal = house.graph().portals[crossings[c].portal];
        EXPECT_EQ(cell, portal.cellBehind(!crossings[c].from_front));
        EXPECT_GE(crossings[c].distance, c == 0 ? -1 : crossings[c - 1].distance - 0.2f);
        cell = portal.cellBehind(crossings[c].from_front);
      }
    }
  }
  EXPECT_GT(with_portals, 1000);
}

}  // namespace
}  // namespace enfilade
