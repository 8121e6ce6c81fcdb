#include <gtest/gtest.h>

#include <cmath>

#include "analytic_scene.h"
#include "ibr/portal_capture.h"
#include "ibr/portal_frame.h"

namespace enfilade {
namespace {

using testing::doorway;

/// An upright rectangle on the floor with its middle at `at`, its front toward `heading` [rad].
Portal uprightPortal(const glm::vec3& at, float heading, float width, float height) {
  const glm::vec3 normal(std::sin(heading), 0, std::cos(heading));
  const glm::vec3 right(std::cos(heading), 0, -std::sin(heading));
  Portal portal;
  const glm::vec3 half = 0.5f * width * right;
  const glm::vec3 up(0, height, 0);
  portal.polygon = {at - half, at + half, at + half + up, at - half + up};
  portal.plane = {normal, -glm::dot(normal, at)};
  return portal;
}

TEST(Viewpoints, StandOnASemicircleBeforeThePortalAtEyeHeight) {
  const ImageParameters parameters;
  for (const bool from_front : {true, false}) {
    const Portal portal = uprightPortal({3, 0.5f, -2}, 0.7f, 1.0f, 2.1f);
    const auto viewpoints = semicircleViewpoints(portal, from_front, 2.1f, parameters, {});
    ASSERT_EQ(viewpoints.size(), 13u);
    const double side = from_front ? 1.0 : -1.0;
    for (const glm::dvec3& at : viewpoints) {
      EXPECT_NEAR(glm::length(glm::dvec2(at.x - 3, at.z + 2)), 1.5, 1e-6);
      EXPECT_NEAR(at.y, 2.1, 1e-6);
      EXPECT_GT(side * glm::dot(glm::dvec3(portal.plane.normal), at - glm::dvec3(3, 0.5, -2)),
                0.38);
    }
    // The central one in the middle, the outermost at 75°, from left to right.
    const glm::dvec3 normal = side * glm::dvec3(portal.plane.normal);
    EXPECT_NEAR(glm::dot(normal, viewpoints[6] - glm::dvec3(3, 2.1, -2)), 1.5, 1e-6);
    EXPECT_NEAR(glm::dot(normal, viewpoints[0] - glm::dvec3(3, 2.1, -2)),
                1.5 * std::cos(glm::radians(75.0)), 1e-6);
    const glm::dvec3 right = portalFrame(portal, from_front).right;
    EXPECT_LT(glm::dot(right, viewpoints[0]), glm::dot(right, viewpoints[12]));
  }
}

TEST(Viewpoints, AreCrossedByEveryLevelSightFromBeyondTheSwitchDistance) {
  // Also where the portal is wider than the semicircle: the outermost part stays within the switch
  // distance of the portal, and the curve goes around it.
  const CaptureRing ring{101, 85.0f, 0.0f};
  for (const float width : {0.8f, 2.0f, 3.5f, 8.0f}) {
    const Portal portal = uprightPortal({0, 0, 0}, 0, width, 2.1f);
    for (const glm::dvec3& at : semicircleViewpoints(portal, true, 1.6f, {}, ring)) {
      const double beside = std::max(0.0, std::abs(at.x) - 0.5 * static_cast<double>(width));
      EXPECT_LE(std::hypot(beside, at.z), 1.5 + 1e-6) << width;
    }
    const auto outermost = semicircleViewpoints(portal, true, 1.6f, {}, ring).back();
    EXPECT_GT(outermost.x, 0.5 * static_cast<double>(width)) << width;
  }
}

TEST(Viewpoints, StartInTheMiddleAndFollowThePlanRingByRing) {
  ImageParameters parameters;
  parameters.rings = {{5, 75.0f, 0.0f}, {2, 60.0f, -0.5f}};
  const auto viewpoints = captureViewpoints(doorway(), true, 1.6f, parameters);
  ASSERT_EQ(viewpoints.size(), 7u);
  EXPECT_NEAR(viewpoints[0].x, 0.0, 1e-9);
  EXPECT_NEAR(viewpoints[0].z, 1.5, 1e-6);
  for (std::size_t i = 1; i < 5; ++i) {
    EXPECT_NEAR(viewpoints[i].y, 1.6, 1e-6);
    EXPECT_GE(std::abs(viewpoints[i].x), std::abs(viewpoints[i - 1].x) - 1e-6);
  }
  EXPECT_NEAR(viewpoints[5].y, 1.1, 1e-6);
  EXPECT_NEAR(viewpoints[5].x, -1.5 * std::sin(glm::radians(60.0)), 1e-6);
  EXPECT_NEAR(viewpoints[6].x, 1.5 * std::sin(glm::radians(60.0)), 1e-6);
}

TEST(Viewpoints, HaveTheCentralOneEvenIfTheRingHasNone) {
  ImageParameters parameters;
  parameters.rings = {{2, 75.0f, 0.0f}};
  const auto viewpoints = captureViewpoints(doorway(), true, 1.6f, parameters);
  ASSERT_EQ(viewpoints.size(), 3u);
  EXPECT_NEAR(viewpoints[0].x, 0.0, 1e-9);
}

TEST(Viewpoints, LeaveOutThoseBehindALeaningPortal) {
  // Leans over the viewer by 25°: whoever stands low is before it, whoever stands high behind.
  Portal portal = doorway();
  const float lean = std::tan(glm::radians(25.0f));
  for (glm::vec3& corner : portal.polygon) {
    corner.z = lean * corner.y;
  }
  const glm::vec3 normal = glm::normalize(glm::vec3(0, -lean, 1));
  portal.plane = {normal, -glm::dot(normal, portal.polygon[0])};
  ImageParameters parameters;
  parameters.switch_distance = 0.5f;
  const auto low = captureViewpoints(portal, true, 0.5f, parameters);
  const auto high = captureViewpoints(portal, true, 2.5f, parameters);
  std::size_t all = 0;
  for (const CaptureRing& ring : parameters.rings) all += static_cast<std::size_t>(ring.captures);
  EXPECT_EQ(low.size(), all);
  EXPECT_LT(high.size(), all);
  for (const auto& viewpoints : {low, high}) {
    for (const glm::dvec3& at : viewpoints) {
      EXPECT_GT(portal.plane.signedDistance(glm::vec3(at)), 0.049f);
    }
  }
}

TEST(Portals, ShowImagesIfUprightAndOfSomeSize) {
  EXPECT_TRUE(canShowImages(doorway()));
  EXPECT_FALSE(canShowImages(uprightPortal({0, 0, 0}, 0, 0.1f, 2.0f)));
  EXPECT_FALSE(canShowImages(uprightPortal({0, 0, 0}, 0, 2.0f, 0.1f)));
  Portal hatch;
  hatch.polygon = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}};
  hatch.plane = {{0, 1, 0}, 0};
  EXPECT_FALSE(canShowImages(hatch));
}

TEST(PortalCamera, LooksThroughThePortalAndItsMargin) {
  ImageParameters parameters;
  parameters.image_size = 256;
  parameters.portal_margin = 0.05f;
  for (const bool from_front : {true, false}) {
    const Portal portal = uprightPortal({3, 0.5f, -2}, 0.7f, 1.0f, 2.0f);
    for (const glm::dvec3& at : semicircleViewpoints(portal, from_front, 1.6f, parameters, {})) {
      const PlanarCamera camera = portalCamera(portal, from_front, at, parameters);
      EXPECT_EQ(camera.height, 256);
      EXPECT_EQ(camera.width, 134);  // 256 · 1.1 / 2.1
      // The four corners, 5 cm inside the window, on the image plane, the right way up.
      const double margin_x = 0.05 / 1.1 * camera.width;
      const double margin_y = 0.05 / 2.1 * camera.height;
      for (std::size_t i = 0; i < 4; ++i) {
        const glm::dvec3 seen = projectPoint(camera, glm::dvec3(portal.polygon[i]));
        const bool left = (i == 0 || i == 3) == from_front;
        EXPECT_NEAR(seen.x, left ? margin_x : camera.width - margin_x, 1e-3);
        EXPECT_NEAR(seen.y, i >= 2 ? margin_y : camera.height - margin_y, 1e-3);
        EXPECT_NEAR(seen.z, 1.0, 1e-6);
      }
    }
  }
}

TEST(PortalCamera, WidensAboutItsMiddle) {
  ImageParameters parameters;
  parameters.image_size = 256;
  parameters.portal_margin = 0;
  const Portal portal = doorway();
  const PlanarCamera camera = portalCamera(portal, true, {0, 1.6, 1.5}, parameters, 3.0);
  EXPECT_EQ(camera.height, 768);
  const glm::dvec3 corner = projectPoint(camera, glm::dvec3(portal.polygon[0]));
  EXPECT_NEAR(corner.x, camera.width / 3.0, 1e-3);
  EXPECT_NEAR(corner.y, camera.height * 2 / 3.0, 1e-3);
}

TEST(PortalCamera, HasTheSameResolutionBeforeEveryPortal) {
  ImageParameters parameters;
  parameters.image_size = 210;  // one pixel a centimetre
  parameters.portal_margin = 0;
  Portal window = doorway();
  for (glm::vec3& corner : window.polygon) corner.y = 0.9f + 0.5f * corner.y;
  const PlanarCamera low = portalCamera(window, true, {0, 1.6, 1.5}, parameters);
  EXPECT_EQ(low.height, 105);
  EXPECT_EQ(low.width, 100);
  // But no more pixels than the machine is sure to draw.
  for (glm::vec3& corner : window.polygon) corner.x *= 100.0f;
  const PlanarCamera wide = portalCamera(window, true, {0, 1.6, 1.5}, parameters);
  EXPECT_EQ(wide.width, 4096);
  EXPECT_EQ(wide.height, 43);
}

}  // namespace
}  // namespace enfilade
