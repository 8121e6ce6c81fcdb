#include <gtest/gtest.h>

#include "render/renderer.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWidth = 80;
constexpr int kHeight = 64;

ScreenPolygon polygonAt(const glm::vec2& low, const glm::vec2& high, float z) {
  const auto corners = rectangle(low, high, z);
  return {{corners.begin(), corners.end()}};
}

/// At z = −2: the pixels [20, 60) × [8, 48).
ScreenPolygon portal() { return polygonAt({-1.25f, -1}, {1.25f, 1.5f}, -2); }
bool insidePortal(int x, int y) { return x >= 20 && x < 60 && y >= 8 && y < 48; }

/// One colour; transparent where `hole(x, y)`.
template <typename Hole>
Image picture(const Hole& hole) {
  Image image{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const int v : {90, 80, 70, hole(x, y) ? 0 : 255}) {
        image.rgba.push_back(static_cast<std::uint8_t>(v));
      }
    }
  }
  return image;
}

bool noHole(int, int) { return false; }
bool columnHole(int x, int) { return x >= 30 && x < 34; }

/// Screen polygons with a picture, the building, and what can be seen of the polygons.
class VisiblePolygons : public testing::Test {
 protected:
  void draw(const std::vector<ScreenPolygon>& polygons, const Image& shown) {
    Renderer renderer(sharedContext(), building_);
    renderer.begin(kWidth, kHeight);
    renderer.drawScreenPolygons(polygons, shown, {0, 0, kWidth, kHeight}, camera_.clipFromWorld());
    renderer.draw(allObjects(building_), camera_.view());
    renderer.readColor(before_);
    renderer.readVisible(polygons, camera_.clipFromWorld(), visible_);
    renderer.readColor(after_);
  }

  /// Every pixel's mark is `right(x, y)`.
  template <typename Right>
  void expectMarks(const Right& right) {
    ASSERT_EQ(visible_.size(), static_cast<std::size_t>(kWidth * kHeight));
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_EQ(int{visible_[static_cast<std::size_t>(y * kWidth + x)]}, right(x, y))
            << "at " << x << ", " << y;
      }
    }
  }

  Building building_;
  Camera camera_ = frontCamera(kWidth, kHeight);
  Image before_, after_;
  std::vector<std::uint8_t> visible_;
};

TEST_F(VisiblePolygons, AWallBeforeHalfAPortalHidesThatHalf) {
  addQuad(building_, rectangle({-9, -9}, {0, 9}, -1.5f), unlitMaterial({1, 0, 0, 1}));
  addQuad(building_, rectangle({-9, -9}, {9, 9}, -5), unlitMaterial({0, 1, 0, 1}));
  draw({portal()}, picture(noHole));
  expectMarks([](int x, int y) { return x >= 40 && insidePortal(x, y) ? 1 : 0; });
}

TEST_F(VisiblePolygons, AHoleInThePictureIsThePortalsWhateverShowsThroughIt) {
  draw({portal()}, picture(columnHole));
  expectMarks([](int x, int y) { return insidePortal(x, y) ? 1 : 0; });
  addQuad(building_, rectangle({-9, -9}, {9, 9}, -5), unlitMaterial({0, 1, 0, 1}));
  draw({portal()}, picture(columnHole));
  EXPECT_EQ(pixelAt(before_, 31, 20), kGreen);
  expectMarks([](int x, int y) { return insidePortal(x, y) ? 1 : 0; });
}

TEST_F(VisiblePolygons, WhatStandsInAHoleBeforeThePortalIsNotThePortals) {
  addQuad(building_, rectangle({-9, -9}, {9, 9}, -1.9f), unlitMaterial({0, 1, 0, 1}));
  draw({portal()}, picture(columnHole));
  expectMarks([](int, int) { return 0; });
}

TEST_F(VisiblePolygons, GlassBeforeThePortalLeavesItThePortals) {
  Material glass = unlitMaterial({0, 0, 1, 0.5f});
  glass.alpha_mode = AlphaMode::kBlend;
  addQuad(building_, rectangle({-9, -9}, {0, 9}, -1.5f), glass);
  draw({portal()}, picture(noHole));
  EXPECT_NE(pixelAt(before_, 30, 20), pixelAt(before_, 50, 20));
  expectMarks([](int x, int y) { return insidePortal(x, y) ? 1 : 0; });
}

TEST_F(VisiblePolygons, OfTwoPortalsTheNearerHasThePixelAndItsHolesInAnyOrder) {
  const ScreenPolygon far = polygonAt({-9, -9}, {9, 9}, -4);
  const auto near = [](int x, int y) { return insidePortal(x, y); };
  draw({portal(), far}, picture(columnHole));
  expectMarks([&](int x, int y) { return near(x, y) ? 1 : 2; });
  draw({far, portal()}, picture(columnHole));
  expectMarks([&](int x, int y) { return near(x, y) ? 2 : 1; });
}

TEST_F(VisiblePolygons, OfTwoAtOneDepthTheFirstDrawnHasThePixel) {
  draw({portal(), portal()}, picture(noHole));
  expectMarks([](int x, int y) { return insidePortal(x, y) ? 1 : 0; });
}

TEST_F(VisiblePolygons, MoreThanAMarkCanCountShareTheLast) {
  const std::vector<ScreenPolygon> polygons(300, portal());
  std::vector<ScreenPolygon> nearer = polygons;
  nearer[299] = polygonAt({-0.1f, -0.1f}, {0.1f, 0.1f}, -1);
  draw(nearer, picture(noHole));
  EXPECT_EQ(visible_[static_cast<std::size_t>(32 * kWidth + 40)], 255);
  EXPECT_EQ(visible_[static_cast<std::size_t>(10 * kWidth + 22)], 1);
}

TEST_F(VisiblePolygons, LookingLeavesThePictureAsItIsWithAlphaOpaque) {
  addQuad(building_, rectangle({-9, -9}, {0, 9}, -1.5f), unlitMaterial({1, 0, 0, 1}));
  draw({portal()}, picture(columnHole));
  EXPECT_EQ(before_.rgba, after_.rgba);
  for (std::size_t i = 3; i < after_.rgba.size(); i += 4) ASSERT_EQ(after_.rgba[i], 255);
}

}  // namespace
}  // namespace enfilade
