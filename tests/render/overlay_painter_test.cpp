#include "render/overlay_painter.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

constexpr int kSide = 8;  // of OSMesa's own framebuffer

class OverlayPainterTest : public ::testing::Test {
 protected:
  OverlayPainterTest() : context_(createOsMesaContext(1)), overlay_(*context_) {
    overlay_.begin({kSide, kSide});
    overlay_.box({glm::vec2(0), glm::vec2(kSide)}, {0, 0, 0, 1});
  }
  glm::ivec3 pixel(int x, int y) {
    overlay_.end();
    const Image picture = overlay_.read();
    const std::uint8_t* p = &picture.rgba[4 * static_cast<std::size_t>(y * kSide + x)];
    return {p[0], p[1], p[2]};
  }

  std::unique_ptr<GlContext> context_;
  OverlayPainter overlay_;
};

TEST_F(OverlayPainterTest, ABoxFillsItsPixelsFromTheUpperLeftOn) {
  overlay_.box({{1, 2}, {4, 3}}, {1, 0, 0, 1});
  EXPECT_EQ(pixel(1, 2), glm::ivec3(255, 0, 0));
  EXPECT_EQ(pixel(3, 2), glm::ivec3(255, 0, 0));
  EXPECT_EQ(pixel(4, 2), glm::ivec3(0));
  EXPECT_EQ(pixel(1, 3), glm::ivec3(0));
  EXPECT_EQ(pixel(1, 1), glm::ivec3(0));
}

TEST_F(OverlayPainterTest, WhatIsDrawnLaterLiesOnTopAndLetsShowThroughWhatItShould) {
  overlay_.box({glm::vec2(0), glm::vec2(kSide)}, {1, 1, 1, 1});
  overlay_.box({glm::vec2(0), glm::vec2(kSide)}, {0, 0, 0, 0.5f});
  EXPECT_NEAR(pixel(4, 4).x, 128, 2);
}

TEST_F(OverlayPainterTest, NothingShowsOutsideTheClip) {
  overlay_.clipTo({{2, 2}, {5, 8}});
  overlay_.box({glm::vec2(0), glm::vec2(kSide)}, {0, 1, 0, 1});
  EXPECT_EQ(pixel(2, 2), glm::ivec3(0, 255, 0));
  EXPECT_EQ(pixel(4, 7), glm::ivec3(0, 255, 0));
  EXPECT_EQ(pixel(1, 4), glm::ivec3(0));
  EXPECT_EQ(pixel(5, 4), glm::ivec3(0));
  EXPECT_EQ(pixel(3, 1), glm::ivec3(0));
}

TEST_F(OverlayPainterTest, APictureStandsUprightAndIsKeptUntilItChanges) {
  Image picture;
  picture.width = picture.height = 2;
  picture.rgba = {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
  const PixelBox whole{glm::vec2(0), glm::vec2(kSide)};
  overlay_.picture(whole, picture, 0, true, false);
  EXPECT_EQ(pixel(1, 1), glm::ivec3(255, 0, 0));
  EXPECT_EQ(pixel(6, 1), glm::ivec3(0, 255, 0));
  EXPECT_EQ(pixel(1, 6), glm::ivec3(0, 0, 255));
  const Image other{2, 2, std::vector<std::uint8_t>(16, 255)};
  overlay_.begin({kSide, kSide});
  overlay_.picture(whole, other, 0, false, false);
  EXPECT_EQ(pixel(1, 1), glm::ivec3(255, 0, 0));
  overlay_.begin({kSide, kSide});
  overlay_.picture(whole, other, 0, true, false);
  EXPECT_EQ(pixel(1, 1), glm::ivec3(255));
}

TEST_F(OverlayPainterTest, TextLeavesInkWhereItStands) {
  overlay_.text("M", {0, 0}, {8, FontFace::kBold, {1, 1, 1, 1}});
  int ink = 0;
  for (int x = 0; x < kSide; ++x) ink += pixel(x, 4).x;
  EXPECT_GT(ink, 255);
}

TEST_F(OverlayPainterTest, MoreLettersThanFitAtOnceAreDrawnAllTheSame) {
  for (int size = 20; size < 200; size += 4) {
    overlay_.text("ABCDEFGHIJKLMNOPQRSTUVWXYZ", {0, 0}, {static_cast<float>(size)});
  }
  overlay_.box({glm::vec2(0), glm::vec2(kSide)}, {0, 0, 0, 1});
  overlay_.text("M", {0, 0}, {8, FontFace::kBold, {1, 1, 1, 1}});
  int ink = 0;
  for (int x = 0; x < kSide; ++x) ink += pixel(x, 4).x;
  EXPECT_GT(ink, 255);
}

}  // namespace
}  // namespace enfilade
