#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

#include "render/shading.h"
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

TEST(Renderer, MirroredObjectsKeepTheirFrontAndTheirLight) {
  const auto drawn = [&](const std::array<glm::vec3, 4>& corners, const glm::mat4& transform) {
    Building building;
    Material material;
    material.base_color = {0.5f, 0.5f, 0.5f, 1};
    addQuad(building, corners, material, transform);
    return draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight);
  };
  const auto corners = rectangle({-1, -1}, {1, 1}, -2);
  const glm::mat4 mirror = glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1));
  const Image plain = drawn(corners, glm::mat4(1));
  EXPECT_NE(pixelAt(plain, 40, 32), kSky);
  EXPECT_EQ(drawn(corners, mirror).rgba, plain.rgba);
  // Mirrored in depth it looks away.
  const auto behind = rectangle({-1, -1}, {1, 1}, 2);
  const Image away = drawn(behind, glm::scale(glm::mat4(1), glm::vec3(1, 1, -1)));
  EXPECT_EQ(pixelAt(away, 40, 32), kSky);
}

TEST(Renderer, BackFacesAreLitByTheirReversedNormal) {
  const auto drawn = [&](bool turned) {
    Building building;
    Material material;
    material.double_sided = true;
    auto corners = rectangle({-1, -1}, {1, 1}, -2);
    if (turned) std::swap(corners[1], corners[3]);
    addQuad(building, corners, material);
    return pixelAt(draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight), 40, 32);
  };
  EXPECT_EQ(drawn(false), drawn(true));
}

TEST(Renderer, ColorIsBaseColorTimesVertexColorTimesTheLight) {
  Building building;
  Material material;
  material.base_color = {0.8f, 0.4f, 0.2f, 1};
  addQuad(building, rectangle({-3, -3}, {3, 3}, -2), material);
  building.vertex_arrays[0].colors.assign(4, glm::u16vec4(32768, 65535, 6554, 65535));
  const glm::ivec4 pixel =
      pixelAt(draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight), 40, 32);
  const double light = skyAndSun({0, 0, 1});
  const glm::dvec3 linear(0.8 * 32768 / 65535, 0.4, 0.2 * 6554 / 65535);
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(pixel[c], 255 * light * std::pow(linear[c], 1 / 2.2), 0.51) << "channel " << c;
  }
}

TEST(Renderer, TextureStandsUprightAndIsShownAsStored) {
  Building building;
  Material material = unlitMaterial({1, 1, 1, 1});
  material.image = 0;
  material.nearest_filter = true;
  material.wrap_s = material.wrap_t = Wrap::kClampToEdge;
  Image image;
  image.width = image.height = 2;
  image.rgba = {10, 20, 30, 255, 255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255};
  building.images.push_back({"", image, {}, ""});
  addQuad(building, pixelQuad(20, 12, 60, 52), material);
  const Image drawn = draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight);
  EXPECT_EQ(pixelAt(drawn, 21, 13), glm::ivec4(10, 20, 30, 255));
  EXPECT_EQ(pixelAt(drawn, 58, 13), kRed);
  EXPECT_EQ(pixelAt(drawn, 21, 50), kGreen);
  EXPECT_EQ(pixelAt(drawn, 58, 50), kBlue);
}

TEST(Renderer, FarTexturesAreAveragedByMipLevels) {
  Building building;
  Material material = unlitMaterial({1, 1, 1, 1});
  material.image = 0;
  building.images.push_back({"", checkers(64, 1, {0, 0, 0, 255}, {200, 100, 50, 255}), {}, ""});
  addQuad(building, rectangle({-30, -30}, {30, 30}, -10), material);
  building.vertex_arrays[0].texcoords = {{0, 0}, {40, 0}, {40, 40}, {0, 40}};
  const Image drawn = draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      EXPECT_LE(glm::length(glm::vec4(pixelAt(drawn, x, y) - glm::ivec4(100, 50, 25, 255))), 2.0f);
    }
  }
}

TEST(Renderer, MaskedTexelsBelowTheCutoffLetThroughWhatIsBehind) {
  Building building;
  Material mask = unlitMaterial({1, 0, 0, 1});
  mask.image = 0;
  mask.nearest_filter = true;
  mask.alpha_mode = AlphaMode::kMask;
  mask.alpha_cutoff = 0.5f;
  Image image;
  image.width = 2;
  image.height = 1;
  image.rgba = {255, 255, 255, 127, 255, 255, 255, 128};
  building.images.push_back({"", image, {}, ""});
  addQuad(building, pixelQuad(0, 0, kWidth, kHeight), mask);
  addQuad(building, rectangle({-9, -9}, {9, 9}, -3), unlitMaterial({0, 0, 1, 1}));
  const Image drawn = draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight);
  EXPECT_EQ(pixelAt(drawn, 10, 32), kBlue);
  EXPECT_EQ(pixelAt(drawn, 70, 32), kRed);
}

TEST(Renderer, BlendedObjectsAreDrawnLastAndFarthestFirst) {
  const auto pane = [](const glm::vec3& color) {
    Material material = unlitMaterial({color, 0.5f});
    material.alpha_mode = AlphaMode::kBlend;
    return material;
  };
  Building building;
  addQuad(building, rectangle({-1, -1}, {1, 1}, -2), pane({1, 0, 0}));
  addQuad(building, rectangle({-9, -9}, {9, 9}, -4), pane({0, 1, 0}));
  addQuad(building, rectangle({-9, -9}, {9, 9}, -6), unlitMaterial({0, 0, 1, 1}));
  addQuad(building, rectangle({-9, -9}, {9, 9}, -8), pane({1, 1, 1}));
  const Image drawn = draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight);
  const glm::ivec4 through_both = pixelAt(drawn, 40, 32);
  EXPECT_NEAR(through_both.r, 127.5, 1.6);
  EXPECT_NEAR(through_both.g, 63.75, 1.6);
  EXPECT_NEAR(through_both.b, 63.75, 1.6);
  EXPECT_EQ(through_both.a, 255);
  const glm::ivec4 through_green = pixelAt(drawn, 2, 32);
  EXPECT_NEAR(through_green.g, 127.5, 1.6);
  EXPECT_NEAR(through_green.b, 127.5, 1.6);
}

TEST(Renderer, OfCoplanarFacesTheFirstObjectIsSeen) {
  Building building;
  addQuad(building, rectangle({-9, -9}, {9, 9}, -2), unlitMaterial({1, 0, 0, 1}));
  addQuad(building, rectangle({-9, -9}, {9, 9}, -2), unlitMaterial({0, 1, 0, 1}));
  const Image drawn = draw(building, frontCamera(kWidth, kHeight), kWidth, kHeight);
  EXPECT_EQ(pixelAt(drawn, 40, 32), kRed);
}

TEST(Renderer, ObjectsOfOneStateShareADrawCall) {
  Building building;
  for (int i = 0; i < 10; ++i) {
    addQuad(building, rectangle({-1, -1}, {1, 1}, -2.0f - static_cast<float>(i)),
            unlitMaterial({0.1f * static_cast<float>(i), 0, 0, 1}));
  }
  Renderer renderer(sharedContext(), building);
  renderer.setSifting(false);  // all but the first are hidden
  renderer.begin(kWidth, kHeight);
  const std::vector<std::uint32_t> some = {0, 1, 2, 5, 6, 9};
  const DrawCounts counts = renderer.draw(some, frontCamera(kWidth, kHeight).view());
  EXPECT_EQ(counts.triangles, 12u);
  EXPECT_EQ(counts.draw_calls, 1u);
}

TEST(Renderer, FramesOfChangingSizeStartAfresh) {
  Building building;
  addQuad(building, rectangle({-9, -9}, {9, 9}, -2), unlitMaterial({1, 0, 0, 1}));
  Renderer renderer(sharedContext(), building);
  Image image;
  std::vector<float> depth;
  for (const glm::ivec2 size : {glm::ivec2(40, 32), glm::ivec2(7, 3), glm::ivec2(333, 222)}) {
    renderer.begin(size.x, size.y);
    renderer.draw(allObjects(building), frontCamera(size.x, size.y).view());
    renderer.begin(size.x, size.y);
    renderer.readColor(image);
    renderer.readDepth(depth);
    EXPECT_EQ(image.width, size.x);
    EXPECT_EQ(image.height, size.y);
    EXPECT_EQ(pixelAt(image, size.x - 1, size.y - 1), kSky);
    EXPECT_EQ(depth, std::vector<float>(static_cast<std::size_t>(size.x * size.y), 1.0f));
  }
}

TEST(Renderer, ShowTurnsTheFrameTheWayAWindowHasIt) {
  Building building;
  addQuad(building, rectangle({-9, 0}, {9, 9}, -2), unlitMaterial({1, 0, 0, 1}));
  Renderer renderer(sharedContext(), building);
  const GlFunctions& gl = sharedContext().gl();
  gl.BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    GTEST_SKIP() << "this context has no framebuffer of its own";
  }
  renderer.begin(8, 8);
  renderer.draw(allObjects(building), frontCamera(8, 8).view());
  renderer.show(8, 8);
  Image still_there;
  renderer.readColor(still_there);
  EXPECT_EQ(pixelAt(still_there, 3, 0), kRed);

  std::array<std::uint8_t, 4 * 8 * 8> window{};
  gl.BindFramebuffer(GL_READ_FRAMEBUFFER, 0);
  gl.ReadPixels(0, 0, 8, 8, GL_RGBA, GL_UNSIGNED_BYTE, window.data());
  EXPECT_EQ(window[4 * 8 * 7], 255);   // the top row, OpenGL's last, is red
  EXPECT_EQ(window[0], kSkyColor[0]);  // the bottom row is sky
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
