#include "ibr/viewpoint_fan.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "analytic_scene.h"
#include "random_cameras.h"

namespace enfilade {
namespace {

const auto kAny = [](std::size_t) { return true; };

/// The angle between two directions in plan, by the dot product of unit vectors.
double angleBetween(glm::dvec3 a, glm::dvec3 b) {
  a.y = b.y = 0;
  return std::acos(glm::clamp(glm::dot(glm::normalize(a), glm::normalize(b)), -1.0, 1.0));
}

TEST(ViewpointFan, TheNearestHasTheLeastAngleInPlan) {
  testing::Random random(51);
  const Portal portal = testing::doorway();
  const glm::dvec3 middle(0, 1.05, 0);
  for (int i = 0; i < 300; ++i) {
    const ViewpointFan fan(portal, true, 1.6f, {}, random(1, 30));
    const double angle = random(-1.5, 1.5), distance = random(0.2, 20.0);
    const glm::dvec3 eye(distance * std::sin(angle), random(0.0, 4.0), distance * std::cos(angle));
    const std::size_t nearest = fan.nearest(eye, kAny);
    ASSERT_LT(nearest, fan.size());
    for (const glm::dvec3& other : fan.viewpoints()) {
      EXPECT_LE(angleBetween(fan.viewpoints()[nearest] - middle, eye - middle),
                angleBetween(other - middle, eye - middle) + 1e-9);
    }
  }
}

TEST(ViewpointFan, AnEyeBehindAViewpointGetsThatOneOnBothSidesOfThePortal) {
  for (const bool from_front : {true, false}) {
    const ViewpointFan fan(testing::doorway(), from_front, 1.6f, {}, 6);
    ASSERT_EQ(fan.size(), 6u);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const glm::dvec3 at = fan.viewpoints()[i];
      EXPECT_EQ(at.z > 0, from_front);
      EXPECT_EQ(fan.nearest(at, kAny), i);
      EXPECT_EQ(fan.nearest(glm::dvec3(4.0 * at.x, 0.3, 4.0 * at.z), kAny), i);
    }
    EXPECT_LT(fan.bearing(fan.viewpoints().front()), 0) << "the first stands at the left";
  }
}

TEST(ViewpointFan, TheSecondNearestIsTheNearestOfTheOthers) {
  const ViewpointFan fan(testing::doorway(), true, 1.6f, {}, 6);
  const glm::dvec3 eye = 0.6 * fan.viewpoints()[2] + 0.4 * fan.viewpoints()[3];
  EXPECT_EQ(fan.nearest(eye, kAny), 2u);
  EXPECT_EQ(fan.nearest(eye, [](std::size_t i) { return i != 2; }), 3u);
  EXPECT_EQ(fan.nearest(eye, [](std::size_t) { return false; }), ViewpointFan::kNone);
  EXPECT_EQ(ViewpointFan().nearest(eye, kAny), ViewpointFan::kNone);
}

TEST(ViewpointFan, LeavesOutViewpointsThatDoNotStandBeforeASlopingPortal) {
  // Leans toward the viewer by 29°, and is high up: from below one looks at its back.
  Portal portal = testing::doorway();
  const double lean = glm::radians(29.0);
  for (glm::vec3& corner : portal.polygon) {
    corner = glm::vec3(corner.x, 3.0 + corner.y * std::cos(lean), corner.y * std::sin(lean));
  }
  portal.plane = planeOf(portal.polygon);
  const ViewpointFan fan(portal, true, 6.0f, {}, 13);
  EXPECT_LT(fan.size(), 13u);
  for (const glm::dvec3& at : fan.viewpoints()) {
    EXPECT_GT(portal.plane.signedDistance(glm::vec3(at)), 0.04f);
  }
}

}  // namespace
}  // namespace enfilade
