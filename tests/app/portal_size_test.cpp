#include "app/portal_size.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

Portal portalOf(std::vector<glm::vec3> polygon) {
  Portal portal;
  portal.polygon = std::move(polygon);
  portal.plane = planeOf(portal.polygon);
  return portal;
}

TEST(PortalSize, ADoorHasItsWidthAndHeightWhicheverWayItFaces) {
  const glm::vec3 along = glm::normalize(glm::vec3(3, 0, 4));
  const glm::vec3 up(0, 2.1f, 0);
  const Portal portal = portalOf({{0, 0, 0}, 0.9f * along, 0.9f * along + up, up});
  EXPECT_FALSE(isLevel(portal));
  EXPECT_NEAR(portalSize(portal).x, 0.9f, 1e-5f);
  EXPECT_NEAR(portalSize(portal).y, 2.1f, 1e-5f);
}

TEST(PortalSize, AStairsOpeningIsMeasuredAlongItsLongestEdge) {
  const Portal portal = portalOf({{0, 3, 0}, {0, 3, 1}, {4, 3, 1}, {4, 3, 0}});
  EXPECT_TRUE(isLevel(portal));
  EXPECT_NEAR(portalSize(portal).x, 4, 1e-5f);
  EXPECT_NEAR(portalSize(portal).y, 1, 1e-5f);
}

}  // namespace
}  // namespace enfilade
