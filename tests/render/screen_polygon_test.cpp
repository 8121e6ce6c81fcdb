#include <gtest/gtest.h>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWidth = 80;
constexpr int kHeight = 64;

/// Every pixel another colour; transparent where `transparent(x, y)`.
template <typename Transparent>
Image everyPixelAnother(const Transparent& transparent) {
  Image image;
  image.width = kWidth;
  image.height = kHeight;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const int alpha = transparent(x, y) ? 0 : 255;
      for (const int v : {x, y, 100, alpha}) image.rgba.push_back(static_cast<std::uint8_t>(v));
    }
  }
  return image;
}

/// At z = −2: the pixels [20, 60) × [8, 48).
ScreenPolygon portal() {
  const auto corners = rectangle({-1.25f, -1}, {1.25f, 1.5f}, -2);
  return {{corners.begin(), corners.end()}};
}

bool insidePortal(int x, int y) { return x >= 20 && x < 60 && y >= 8 && y < 48; }

class ScreenPolygons : public testing::Test {
 protected:
  Image drawn(const Image& picture, const glm::ivec4& region) {
    Renderer renderer(sharedContext(), building_);
    renderer.begin(kWidth, kHeight);
    const std::vector<ScreenPolygon> polygons = {portal()};
    renderer.drawScreenPolygons(polygons, picture, region, camera_.clipFromWorld());
    renderer.draw(allObjects(building_), camera_.view());
    Image image;
    renderer.readColor(image);
    renderer.readDepth(depth_);
    return image;
  }

  Building building_;
  Camera camera_ = frontCamera(kWidth, kHeight);
  std::vector<float> depth_;
};

TEST_F(ScreenPolygons, ShowThePictureAtItsOwnPixels) {
  const auto hole = [](int x, int y) { return x > 30 && x < 35 && y > 20 && y < 40; };
  const Image image = drawn(everyPixelAnother(hole), {0, 0, kWidth, kHeight});
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool shown = insidePortal(x, y) && !hole(x, y);
      ASSERT_EQ(pixelAt(image, x, y), shown ? glm::ivec4(x, y, 100, 255) : kSky)
          << "at " << x << ", " << y;
    }
  }
}

TEST_F(ScreenPolygons, HaveTheDepthOfTheirPlane) {
  drawn(everyPixelAnother([](int x, int) { return x == 40; }), {0, 0, kWidth, kHeight});
  const double n = camera_.near_plane;
  const double f = camera_.far_plane;
  EXPECT_NEAR(static_cast<double>(depth_[30 * kWidth + 41]), f / (f - n) * (1 - n / 2), 2e-7);
  EXPECT_EQ(depth_[30 * kWidth + 40], 1.0f);
}

TEST_F(ScreenPolygons, AreReadOnlyInsideTheRegion) {
  const glm::ivec4 region(25, 10, 50, 30);
  const Image picture = everyPixelAnother([](int, int) { return false; });
  const Image image = drawn(picture, region);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool shown = x >= 25 && x < 50 && y >= 10 && y < 30;
      ASSERT_EQ(pixelAt(image, x, y), shown ? glm::ivec4(x, y, 100, 255) : kSky);
    }
  }
  // A region that is empty or beyond the frame is no error.
  EXPECT_EQ(pixelAt(drawn(picture, {30, 30, 30, 40}), 30, 30), kSky);
  EXPECT_EQ(pixelAt(drawn(picture, {-50, -50, 5000, 5000}), 30, 30), glm::ivec4(30, 30, 100, 255));
}

TEST_F(ScreenPolygons, AreHiddenByWhatStandsBeforeThemAndHideWhatIsBehind) {
  addQuad(building_, rectangle({-9, -9}, {0, 9}, -1.5f), unlitMaterial({1, 0, 0, 1}));
  addQuad(building_, rectangle({-9, -9}, {9, 9}, -5), unlitMaterial({0, 1, 0, 1}));
  const Image image =
      drawn(everyPixelAnother([](int, int) { return false; }), {0, 0, kWidth, kHeight});
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const glm::ivec4 right = insidePortal(x, y) ? glm::ivec4(x, y, 100, 255) : kGreen;
      ASSERT_EQ(pixelAt(image, x, y), x < 40 ? kRed : right);
    }
  }
}

TEST_F(ScreenPolygons, TwoPicturesInOneFrameDoNotMix) {
  Renderer renderer(sharedContext(), building_);
  const std::vector<ScreenPolygon> polygons = {portal()};
  renderer.begin(kWidth, kHeight);
  for (const int left : {20, 40}) {
    Image picture = everyPixelAnother([](int, int) { return false; });
    for (std::size_t i = 2; i < picture.rgba.size(); i += 4) {
      picture.rgba[i] = static_cast<std::uint8_t>(left);
    }
    renderer.drawScreenPolygons(polygons, picture, {left, 0, left + 20, kHeight},
                                camera_.clipFromWorld());
  }
  Image image;
  renderer.readColor(image);
  EXPECT_EQ(pixelAt(image, 39, 20), glm::ivec4(39, 20, 20, 255));
  EXPECT_EQ(pixelAt(image, 40, 20), glm::ivec4(40, 20, 40, 255));
}

TEST_F(ScreenPolygons, TexturedPolygonShowsItsTextureUpright) {
  Renderer renderer(sharedContext(), building_);
  Image texture;
  texture.width = texture.height = 2;
  texture.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 9, 9, 9, 255};
  const std::vector<glm::vec2> texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  renderer.begin(kWidth, kHeight);
  renderer.drawTexturedPolygon(portal().polygon, texcoords, texture, camera_.clipFromWorld());
  Image image;
  renderer.readColor(image);
  EXPECT_EQ(pixelAt(image, 21, 9), kRed);
  EXPECT_EQ(pixelAt(image, 58, 9), kGreen);
  EXPECT_EQ(pixelAt(image, 21, 46), kBlue);
  EXPECT_EQ(pixelAt(image, 58, 46), glm::ivec4(9, 9, 9, 255));
  EXPECT_EQ(pixelAt(image, 19, 20), kSky);
}

TEST_F(ScreenPolygons, AKeptTextureIsUploadedOnceAndManyMayBeKept) {
  Renderer renderer(sharedContext(), building_);
  const std::vector<glm::vec2> texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  const auto shown = [&](const glm::ivec4& color, std::uint64_t key) {
    const Image texture = checkers(512, 512, color, color);  // 1 MiB
    renderer.begin(kWidth, kHeight);
    renderer.drawTexturedPolygon(portal().polygon, texcoords, texture, camera_.clipFromWorld(),
                                 key);
    Image image;
    renderer.readColor(image);
    return pixelAt(image, 40, 30);
  };
  EXPECT_EQ(shown(kRed, 1), kRed);
  EXPECT_EQ(shown(kGreen, 2), kGreen);
  EXPECT_EQ(shown(kBlue, 1), kRed) << "it was uploaded again";
  EXPECT_EQ(shown(kBlue, 0), kBlue);
  for (int i = 0; i < 70; ++i) {
    const glm::ivec4 color(i, 0, 0, 255);
    EXPECT_EQ(shown(color, 10 + static_cast<std::uint64_t>(i)), color);
  }
  EXPECT_EQ(shown(kBlue, 1), kBlue) << "the oldest was to give way";
}

TEST_F(ScreenPolygons, APictureOfAnotherSizeBetweenFramesLeavesNoTrace) {
  addQuad(building_, rectangle({-1, -1}, {1, 1}, -3), unlitMaterial({1, 0, 0, 1}));
  Renderer renderer(sharedContext(), building_);
  const auto frame = [&](int width, int height) {
    renderer.begin(width, height);
    renderer.draw(allObjects(building_), camera_.view());
    Image image;
    renderer.readColor(image);
    return image;
  };
  const Image first = frame(kWidth, kHeight);
  for (const int size : {16, 200, 16, 33}) {
    EXPECT_EQ(frame(size, size).width, size);
    EXPECT_EQ(frame(kWidth, kHeight).rgba, first.rgba);
  }
  EXPECT_THROW(renderer.begin(1 << 20, 8), std::exception);
  EXPECT_EQ(frame(kWidth, kHeight).rgba, first.rgba);
}

}  // namespace
}  // namespace enfilade
