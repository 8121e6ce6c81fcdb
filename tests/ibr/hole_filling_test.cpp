#include "ibr/hole_filling.h"

#include <gtest/gtest.h>

#include "ibr/warp.h"
#include "random_cameras.h"

namespace enfilade {
namespace {

using testing::Random;

constexpr int kWidth = 40, kHeight = 30;

Image solid(std::uint8_t value, std::uint8_t alpha) {
  Image image;
  image.width = kWidth;
  image.height = kHeight;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    image.rgba.insert(image.rgba.end(), {value, value, value, alpha});
  }
  return image;
}

std::uint8_t* at(Image& image, int x, int y) {
  return &image.rgba[4 * static_cast<std::size_t>(y * kWidth + x)];
}

std::vector<glm::ivec2> wholeRows() { return std::vector<glm::ivec2>(kHeight, {0, kWidth}); }

void punch(Image& image, int left, int top, int right, int bottom) {
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) std::fill_n(at(image, x, y), 4, std::uint8_t{0});
  }
}

TEST(HoleFilling, PersistTakesWhatTheFrameBeforeHadThereAndNothingElse) {
  Image before = solid(90, 255);
  punch(before, 10, 10, 12, 12);
  Image picture = solid(200, 255);
  punch(picture, 8, 8, 14, 14);
  HoleFiller::persist(before, wholeRows(), 0, kHeight, picture);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool hole = x >= 8 && x < 14 && y >= 8 && y < 14;
      const bool in_both = x >= 10 && x < 12 && y >= 10 && y < 12;
      EXPECT_EQ(at(picture, x, y)[0], in_both ? 0 : hole ? 90 : 200);
      EXPECT_EQ(at(picture, x, y)[3], in_both ? 0 : hole ? kAlphaOfFilling : 255);
    }
  }
}

TEST(HoleFilling, InpaintingGivesAHoleInOneColourThatColour) {
  Image picture = solid(137, 255);
  punch(picture, 5, 5, 25, 22);
  HoleFiller().inpaint(wholeRows(), 0, kHeight, picture);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool hole = x >= 5 && x < 25 && y >= 5 && y < 22;
      EXPECT_EQ(at(picture, x, y)[0], 137);
      EXPECT_EQ(at(picture, x, y)[3], hole ? kAlphaOfFilling : kAlphaOfSample);
    }
  }
}

TEST(HoleFilling, InpaintingReadsAndWritesNothingOutsideTheRegion) {
  Random random(61);
  for (int i = 0; i < 20; ++i) {
    Image picture = solid(100, 255);
    for (std::size_t p = 0; p < picture.rgba.size(); p += 4) {
      picture.rgba[p + 3] = random(0, 3) == 0 ? 0 : 255;
    }
    std::vector<glm::ivec2> spans;
    for (int y = 0; y < kHeight; ++y) {
      const int left = random(0, 10);
      spans.emplace_back(left, left + random(14, 20));
      for (int x = 0; x < kWidth; ++x) {
        if (x < spans.back().x || x >= spans.back().y) {
          const auto alpha = static_cast<std::uint8_t>(random(0, 2) * 255);
          const std::uint8_t other[4] = {250, 250, 250, alpha};
          std::copy_n(other, 4, at(picture, x, y));
        }
      }
    }
    const Image original = picture;
    HoleFiller().inpaint(spans, 3, kHeight - 3, picture);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
        const bool inside = y >= 3 && y < kHeight - 3 && x >= span.x && x < span.y;
        const std::uint8_t* was = &original.rgba[4 * static_cast<std::size_t>(y * kWidth + x)];
        if (inside) {
          EXPECT_EQ(at(picture, x, y)[0], 100);
          EXPECT_GE(at(picture, x, y)[3], kAlphaOfFilling);
        } else {
          EXPECT_TRUE(std::equal(was, was + 4, at(picture, x, y)));
        }
      }
    }
  }
}

TEST(HoleFilling, InpaintingLeavesARegionWithoutAnySampleAsItIs) {
  Image picture = solid(0, 0);
  HoleFiller().inpaint(wholeRows(), 0, kHeight, picture);
  EXPECT_EQ(picture.rgba, solid(0, 0).rgba);
}

TEST(HoleFilling, InpaintingGoesFromTheKnownSidesInward) {
  // Dark on the left, light on the right: the hole between grows lighter from left to right.
  Image picture = solid(40, 255);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 20; x < kWidth; ++x) std::fill_n(at(picture, x, y), 3, std::uint8_t{220});
  }
  punch(picture, 14, 0, 26, kHeight);
  HoleFiller().inpaint(wholeRows(), 0, kHeight, picture);
  for (int x = 14; x < 26; ++x) {
    EXPECT_GE(at(picture, x, 15)[0], at(picture, x - 1, 15)[0]);
    EXPECT_EQ(at(picture, x, 15)[0], x < 20 ? 40 : 220);
  }
}

}  // namespace
}  // namespace enfilade
