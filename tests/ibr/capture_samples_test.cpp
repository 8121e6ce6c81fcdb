#include "ibr/capture_samples.h"

#include <gtest/gtest.h>

#include <random>

#include "analytic_scene.h"

namespace enfilade {
namespace {

/// Looks down −Z from 2 m before the plane z = 0, pixels of 1 cm.
PlanarCamera frontalCamera(int width, int height) {
  PlanarCamera camera;
  camera.center = {0.3, 1.2, 2.0};
  camera.world_from_pixel =
      glm::dmat3({0.01, 0, 0}, {0, -0.01, 0}, {-0.005 * width, 0.005 * height, -2.0});
  camera.width = width;
  camera.height = height;
  return camera;
}

/// A picture of one grey with disparity `at(u, v)` at pixel centres.
template <class At>
DepthImage pictureOf(const PlanarCamera& camera, At&& at) {
  DepthImage image;
  image.camera = camera;
  image.color.width = camera.width;
  image.color.height = camera.height;
  for (int y = 0; y < camera.height; ++y) {
    for (int x = 0; x < camera.width; ++x) {
      image.disparity.push_back(static_cast<float>(at(x + 0.5, y + 0.5)));
      for (int c = 0; c < 4; ++c) {
        image.color.rgba.push_back(100);
      }
    }
  }
  return image;
}

/// Disparity of the plane n·X + d = 0, which is linear in u and v.
auto planeDisparity(const PlanarCamera& camera, const glm::dvec3& n, double d) {
  return [=](double u, double v) {
    const glm::dvec3 ray = camera.world_from_pixel * glm::dvec3(u, v, 1);
    return -glm::dot(n, ray) / (glm::dot(n, camera.center) + d);
  };
}

TEST(CaptureSamples, AreOneAPixelInItsMiddleOnASmoothSurface) {
  const PlanarCamera camera = frontalCamera(12, 8);
  const auto floor = planeDisparity(camera, {0.1, 0.2, 1.0}, 1.0);
  for (const int rays : {1, 2, 4}) {
    const CaptureSamples capture = resolveCapture(pictureOf(camera, floor), rays, 0.05f);
    ASSERT_EQ(capture.samples.size(), static_cast<std::size_t>(96 / (rays * rays)));
    EXPECT_EQ(capture.camera.width, 12 / rays);
    for (const CaptureSample& s : capture.samples) {
      EXPECT_FLOAT_EQ(s.u - std::floor(s.u), 0.5f);
      EXPECT_FLOAT_EQ(s.v - std::floor(s.v), 0.5f);
      EXPECT_EQ(s.width, 1.0f);
      EXPECT_EQ(s.height, 1.0f);
      EXPECT_NEAR(static_cast<double>(s.disparity),
                  floor(static_cast<double>(s.u) * rays, static_cast<double>(s.v) * rays), 1e-6);
    }
  }
}

TEST(CaptureSamples, KnowTheSlopeOfTheirSurfaceAlsoBesideASilhouette) {
  const PlanarCamera camera = frontalCamera(16, 8);
  const auto wall = planeDisparity(camera, {0.3, 0.1, 1.0}, 2.0);
  const auto box = planeDisparity(camera, {-0.2, 0.1, 1.0}, 0.5);
  const DepthImage picture =
      pictureOf(camera, [&](double u, double v) { return u < 9 ? wall(u, v) : box(u, v); });
  for (const CaptureSample& s : resolveCapture(picture, 1, 0.01f).samples) {
    const auto& surface = s.u < 9 ? wall : box;
    const double slope_u = surface(1, 0) - surface(0, 0);
    const double slope_v = surface(0, 1) - surface(0, 0);
    EXPECT_NEAR(static_cast<double>(s.slope_u), slope_u, 1e-6) << s.u;
    EXPECT_NEAR(static_cast<double>(s.slope_v), slope_v, 1e-6) << s.u;
  }
}

TEST(CaptureSamples, SplitAPixelAtASilhouetteAndDoNotMixColours) {
  const PlanarCamera camera = frontalCamera(4, 2);
  DepthImage picture = pictureOf(camera, [](double u, double) { return u < 3 ? 0.8 : 0.4; });
  for (std::size_t pixel = 0; pixel < 8; ++pixel) {
    picture.color.rgba[4 * pixel] = pixel % 4 < 3 ? 200 : 20;
  }
  const CaptureSamples capture = resolveCapture(picture, 2, 0.1f);
  ASSERT_EQ(capture.samples.size(), 3u);
  const CaptureSample& near = capture.samples[1];
  const CaptureSample& far = capture.samples[2];
  EXPECT_FLOAT_EQ(near.disparity, 0.8f);
  EXPECT_FLOAT_EQ(far.disparity, 0.4f);
  EXPECT_FLOAT_EQ(near.u, 1.25f);
  EXPECT_FLOAT_EQ(far.u, 1.75f);
  EXPECT_FLOAT_EQ(near.width, 0.5f);
  EXPECT_FLOAT_EQ(near.height, 1.0f);
  EXPECT_EQ(near.r, 200);
  EXPECT_EQ(far.r, 20);
}

TEST(CaptureSamples, AverageTheColoursOfOneSurface) {
  const PlanarCamera camera = frontalCamera(2, 2);
  DepthImage picture = pictureOf(camera, [](double, double) { return 0.5; });
  const std::uint8_t reds[] = {10, 20, 30, 41};
  for (std::size_t pixel = 0; pixel < 4; ++pixel) {
    picture.color.rgba[4 * pixel] = reds[pixel];
  }
  const CaptureSamples capture = resolveCapture(picture, 2, 0.1f);
  ASSERT_EQ(capture.samples.size(), 1u);
  EXPECT_EQ(capture.samples[0].r, 25);
}

TEST(CaptureSamples, LeaveOutPixelsWhereNothingIsKnown) {
  const PlanarCamera camera = frontalCamera(6, 4);
  const DepthImage picture = pictureOf(camera, [](double u, double) { return u < 3 ? 0.0 : 0.4; });
  const CaptureSamples capture = resolveCapture(picture, 2, 0.1f);
  ASSERT_EQ(capture.samples.size(), 4u);
  EXPECT_FLOAT_EQ(capture.samples[0].u, 1.75f);
  EXPECT_FLOAT_EQ(capture.samples[0].width, 0.5f);
}

TEST(PatchArea, IsTheAreaBetweenThePixelsCorners) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const PlanarCamera camera = frontalCamera(300, 200);
  for (int i = 0; i < 100; ++i) {
    const auto plane = planeDisparity(camera, {0.4 * uniform(random), 0.4 * uniform(random), 1.0},
                                      2.0 + uniform(random));
    const double u = 150 + 100 * uniform(random);
    const double v = 100 + 80 * uniform(random);
    CaptureSample s;
    s.u = static_cast<float>(u);
    s.v = static_cast<float>(v);
    s.disparity = static_cast<float>(plane(u, v));
    s.slope_u = static_cast<float>(plane(1, 0) - plane(0, 0));
    s.slope_v = static_cast<float>(plane(0, 1) - plane(0, 0));
    const auto corner = [&](double du, double dv) {
      return unprojectPoint(camera, {u + du, v + dv, plane(u + du, v + dv)});
    };
    // Both diagonals of the patch span twice its area.
    const double area = 0.5 * glm::length(glm::cross(corner(0.5, 0.5) - corner(-0.5, -0.5),
                                                     corner(-0.5, 0.5) - corner(0.5, -0.5)));
    EXPECT_NEAR(patchArea(camera, s) / area, 1.0, 1e-3);
  }
}

}  // namespace
}  // namespace enfilade
