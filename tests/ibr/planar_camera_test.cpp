#include "ibr/planar_camera.h"

#include <gtest/gtest.h>

#include <glm/gtc/quaternion.hpp>
#include <random>

namespace enfilade {
namespace {

/// A random camera and points that it sees.
class PlanarCameraTest : public ::testing::Test {
 protected:
  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  glm::vec3 point(double range) {
    return {uniform(-range, range), uniform(-range, range), uniform(-range, range)};
  }
  Camera camera() {
    Camera camera;
    camera.pose = lookAt(point(5), point(5));
    camera.vertical_fov = static_cast<float>(uniform(0.3, 1.8));
    camera.aspect = static_cast<float>(uniform(0.5, 2.0));
    camera.near_plane = static_cast<float>(uniform(0.05, 1.0));
    return camera;
  }
  /// An off-axis camera with its image plane anywhere.
  PlanarCamera offAxis() {
    PlanarCamera planar = planarCamera(camera(), 200, 150);
    planar = withWindow(planar, static_cast<int>(uniform(-300, 300)),
                        static_cast<int>(uniform(-300, 300)), 180, 90);
    planar.world_from_pixel *= uniform(0.5, 20.0);
    return planar;
  }

  std::mt19937 random_{1};
};

TEST_F(PlanarCameraTest, SeesAPointAtThePixelWhereOpenGlDrawsIt) {
  for (int i = 0; i < 200; ++i) {
    const Camera c = camera();
    const PlanarCamera planar = planarCamera(c, 640, 512);
    const glm::vec3 world = point(10);
    const glm::vec4 clip = c.clipFromWorld() * glm::vec4(world, 1);
    if (clip.w < 0.1f) {
      continue;
    }
    const glm::dvec3 seen = projectPoint(planar, glm::dvec3(world));
    const double x = 320.0 * (1.0 + static_cast<double>(clip.x / clip.w));
    const double y = 256.0 * (1.0 - static_cast<double>(clip.y / clip.w));
    const double scale = 1.0 + glm::length(glm::dvec2(x, y));
    EXPECT_NEAR(seen.x, x, 2e-5 * scale);
    EXPECT_NEAR(seen.y, y, 2e-5 * scale);
    EXPECT_NEAR(seen.z * static_cast<double>(clip.w) / static_cast<double>(c.near_plane), 1.0,
                1e-4);
  }
}

TEST_F(PlanarCameraTest, GivesBackThePointThatItProjected) {
  for (int i = 0; i < 200; ++i) {
    const PlanarCamera planar = offAxis();
    const glm::dvec3 world(point(10));
    const glm::dvec3 back = unprojectPoint(planar, projectPoint(planar, world));
    EXPECT_LT(glm::distance(back, world), 1e-9);
  }
}

TEST_F(PlanarCameraTest, HasDisparityOneOnItsImagePlaneAndLessBeyond) {
  const PlanarCamera planar = offAxis();
  const glm::dvec3 on_plane = planar.center + planar.world_from_pixel * glm::dvec3(3, 4, 1);
  EXPECT_NEAR(projectPoint(planar, on_plane).z, 1.0, 1e-12);
  EXPECT_NEAR(projectPoint(planar, planar.center + 4.0 * (on_plane - planar.center)).z, 0.25,
              1e-12);
  EXPECT_LT(projectPoint(planar, planar.center - (on_plane - planar.center)).z, 0.0);
  EXPECT_NEAR(imagePlaneDistance(planar),
              glm::length(glm::dot(on_plane - planar.center,
                                   glm::normalize(glm::cross(planar.world_from_pixel[0],
                                                             planar.world_from_pixel[1])))),
              1e-12);
}

TEST_F(PlanarCameraTest, IsDrawnByOpenGlAsItProjects) {
  for (int i = 0; i < 200; ++i) {
    const PlanarCamera planar = offAxis();
    const double near = imagePlaneDistance(planar);
    const double far = near * uniform(5, 500);
    const View view = viewOf(planar, far);
    const double disparity = uniform(near / far, 1.0);
    const glm::dvec3 pixel(uniform(0, planar.width), uniform(0, planar.height), disparity);
    const glm::vec3 world(unprojectPoint(planar, pixel));

    const glm::dvec4 clip(view.clip_from_world * glm::vec4(world, 1));
    const glm::dvec3 ndc = glm::dvec3(clip) / clip.w;
    EXPECT_NEAR(0.5 * (1.0 + ndc.x) * planar.width, pixel.x, 0.02);
    EXPECT_NEAR(0.5 * (1.0 - ndc.y) * planar.height, pixel.y, 0.02);
    const auto depth = static_cast<float>(0.5 * (1.0 + ndc.z));
    EXPECT_NEAR(static_cast<double>(disparityFromDepth(depth, near, far)), disparity, 2e-5);
  }
}

TEST_F(PlanarCameraTest, KnowsTheDisparityOfNearFarAndWhatLiesBetween) {
  EXPECT_FLOAT_EQ(disparityFromDepth(0.0f, 0.5, 50.0), 1.0f);
  EXPECT_FLOAT_EQ(disparityFromDepth(1.0f, 0.5, 50.0), 0.01f);
  // OpenGL's depth at eye depth Z is f / (f − n) · (1 − n / Z).
  const double depth = 50.0 / 49.5 * (1.0 - 0.5 / 3.0);
  EXPECT_NEAR(static_cast<double>(disparityFromDepth(static_cast<float>(depth), 0.5, 50.0)),
              0.5 / 3.0, 6e-8);
}

TEST_F(PlanarCameraTest, KeepsItsRaysInAnotherWindowAndInFinerPixels) {
  const PlanarCamera planar = offAxis();
  const glm::dvec3 world = unprojectPoint(planar, {17.25, 33.5, 0.3});
  const glm::dvec3 in_window = projectPoint(withWindow(planar, 5, -7, 10, 10), world);
  EXPECT_NEAR(in_window.x, 12.25, 1e-9);
  EXPECT_NEAR(in_window.y, 40.5, 1e-9);
  EXPECT_NEAR(in_window.z, 0.3, 1e-12);
  const PlanarCamera fine = refined(planar, 3);
  EXPECT_EQ(fine.width, 3 * planar.width);
  const glm::dvec3 in_fine = projectPoint(fine, world);
  EXPECT_NEAR(in_fine.x, 3 * 17.25, 1e-9);
  EXPECT_NEAR(in_fine.y, 3 * 33.5, 1e-9);
  EXPECT_NEAR(in_fine.z, 0.3, 1e-12);
}

}  // namespace
}  // namespace enfilade
