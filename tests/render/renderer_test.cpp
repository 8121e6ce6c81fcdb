#include "render/renderer.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/error.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWidth = 80;
constexpr int kHeight = 64;

/// The corners, at z = −2, of the quad that covers exactly the pixels [x0, x1) × [y0, y1).
std::array<glm::vec3, 4> pixelQuad(int x0, int y0, int x1, int y1) {
  const auto world = [](int x, int y) {
    return 2.0f * glm::vec2(static_cast<float>(2 * x - kWidth) / kHeight,
                            static_cast<float>(kHeight - 2 * y) / kHeight);
  };
  const glm::vec2 low = world(x0, y1);
  const glm::vec2 high = world(x1, y0);
  return rectangle(low, high, -2.0f);
}

TEST(Renderer, QuadLandsOnExactlyItsPixelsWithRowZeroOnTop) {
  Building building;
  addQuad(building, pixelQuad(10, 5, 31, 18), unlitMaterial({1, 0, 0, 1}));
  const Image image = draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight);
  ASSERT_EQ(image.width, kWidth);
  ASSERT_EQ(image.height, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool inside = x >= 10 && x < 31 && y >= 5 && y < 18;
      ASSERT_EQ(pixelAt(image, x, y), inside ? kRed : kSky) << "at " << x << ", " << y;
    }
  }
}

TEST(Renderer, DepthAgreesWithDoublePrecisionProjection) {
  Building building;
  // A floor that recedes.
  addQuad(building,
          {glm::vec3(-50, -1, -0.5), glm::vec3(50, -1, -0.5), glm::vec3(50, -1, -90),
           glm::vec3(-50, -1, -90)},
          unlitMaterial({1, 0, 0, 1}));
  const Camera camera = frontCamera(kWidth, kHeight);
  Renderer renderer(sharedContext(), building);
  renderer.begin(kWidth, kHeight);
  renderer.draw(allObjects(building), camera.view());
  std::vector<float> depth;
  renderer.readDepth(depth);
  ASSERT_EQ(depth.size(), static_cast<std::size_t>(kWidth * kHeight));
  int met = 0;
  for (int y = 0; y < kHeight; ++y) {
    // The ray through the pixel's centre meets the floor at eye depth −1 / slope.
    const double slope = 1.0 - 2.0 * (y + 0.5) / kHeight;
    const double eye_depth = slope < 0 ? -1.0 / slope : 1e9;
    const double n = camera.near_plane;
    const double f = camera.far_plane;
    const double expected = eye_depth > 90 ? 1.0 : f / (f - n) * (1.0 - n / eye_depth);
    const auto actual = static_cast<double>(depth[static_cast<std::size_t>(y * kWidth + 40)]);
    EXPECT_NEAR(actual, expected, 4e-7) << "row " << y;
    if (eye_depth < 90) ++met;
  }
  EXPECT_GT(met, 25);
}

TEST(Renderer, BackFacesAreDrawnOnlyOfDoubleSidedMaterial) {
  const Camera camera = frontCamera(kWidth, kHeight);
  for (const bool double_sided : {false, true}) {
    for (const bool from_behind : {false, true}) {
      Building building;
      auto corners = pixelQuad(0, 0, kWidth, kHeight);
      if (from_behind) std::swap(corners[1], corners[3]);
      Material material = unlitMaterial({1, 0, 0, 1});
      material.double_sided = double_sided;
      addQuad(building, corners, material);
      const Image image = draw(building, camera, kWidth, kHeight);
      EXPECT_EQ(pixelAt(image, 40, 32), from_behind && !double_sided ? kSky : kRed);
    }
  }
}

TEST(Renderer, SizeBeyondTheMachineIsAnError) {
  Building building;
  Renderer renderer(sharedContext(), building);
  for (const auto& [width, height] : {std::pair{1 << 20, 8}, {0, 8}, {8, -1}}) {
    try {
      renderer.begin(width, height);
      FAIL() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kMachine);
    }
  }
  renderer.begin(8, 8);
  EXPECT_EQ(renderer.draw({}, frontCamera(8, 8).view()).draw_calls, 0u);
}

}  // namespace
}  // namespace enfilade
