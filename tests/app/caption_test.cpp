#include "app/caption.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

Image grey(int width, int height) {
  Image image;
  image.width = width;
  image.height = height;
  image.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 128);
  return image;
}

std::uint8_t levelAt(const Image& image, int x, int y) {
  return image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
}

TEST(Caption, ChangesPixelsOnlyWithinItsBox) {
  for (const glm::ivec2 panel : {glm::ivec2(640, 512), {320, 240}, {100, 400}, {16, 16}}) {
    CaptionPainter painter(panel);
    const Caption caption{"warp2", 1234.5, 1001.3};
    const glm::ivec2 corner(7, 3);
    Image frame = grey(panel.x + 20, panel.y + 20);
    painter.draw(caption, corner, frame);
    const PixelRange box = painter.box(caption);
    EXPECT_TRUE(glm::all(glm::lessThanEqual(box.high, panel)));
    for (int y = 0; y < frame.height; ++y) {
      for (int x = 0; x < frame.width; ++x) {
        const glm::ivec2 at = glm::ivec2(x, y) - corner;
        const bool inside =
            glm::all(glm::greaterThanEqual(at, box.low)) && glm::all(glm::lessThan(at, box.high));
        if (inside) continue;
        ASSERT_EQ(levelAt(frame, x, y), 128) << x << ", " << y;
      }
    }
  }
}

TEST(Caption, IsLightTextOnADarkGround) {
  CaptionPainter painter({640, 512});
  const Caption caption{"ldi", 4.5, 4.4};
  Image frame = grey(640, 512);
  painter.draw(caption, {0, 0}, frame);
  const PixelRange box = painter.box(caption);
  int white = 0, dark = 0, all = 0;
  for (int y = box.low.y; y < box.high.y; ++y) {
    for (int x = box.low.x; x < box.high.x; ++x) {
      ++all;
      white += levelAt(frame, x, y) > 240;
      dark += levelAt(frame, x, y) < 60;
    }
  }
  EXPECT_GT(white, all / 50);
  EXPECT_GT(dark, all / 2);
}

TEST(Caption, ItsBoxAndItsPointStandStillWhileTheTimeChanges) {
  CaptionPainter painter({640, 512});
  const auto drawn = [&](double ms) {
    Image frame = grey(640, 512);
    painter.draw({"ldi", ms, 4.4}, {0, 0}, frame);
    return frame;
  };
  const PixelRange a = painter.box({"ldi", 9.9, 4.4}), b = painter.box({"ldi", 123.9, 4.4});
  EXPECT_EQ(a.low, b.low);
  EXPECT_EQ(a.high, b.high);
  // Only what is left of ".9 ms" differs: all that differs lies left of where 9.8's last digit is.
  const auto lastDifference = [&](const Image& one, const Image& other) {
    int last = -1;
    for (int y = 0; y < one.height; ++y) {
      for (int x = 0; x < one.width; ++x) {
        if (levelAt(one, x, y) != levelAt(other, x, y)) last = std::max(last, x);
      }
    }
    return last;
  };
  const Image short_time = drawn(9.9);
  EXPECT_LT(lastDifference(short_time, drawn(123.9)), lastDifference(short_time, drawn(9.8)));
}

}  // namespace
}  // namespace enfilade
