#include "app/contact_sheet.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

Image uniform(int width, int height, std::uint8_t value) {
  Image image{width, height, {}};
  image.rgba.assign(static_cast<std::size_t>(4 * width * height), value);
  return image;
}

int redAt(const Image& image, int x, int y) {
  return image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
}

TEST(ContactSheet, PicturesStandInTheirRowsAndColumnsWithWhiteBetween) {
  const std::vector<std::vector<Image>> rows = {
      {uniform(10, 6, 1), uniform(10, 6, 2), uniform(10, 6, 3)},
      {uniform(10, 6, 4), uniform(10, 6, 5), uniform(10, 6, 6)}};
  const Image sheet = arranged(rows);
  ASSERT_EQ(sheet.width, 3 * 10 + 2 * kSheetGap);
  ASSERT_EQ(sheet.height, 2 * 6 + kSheetGap);
  for (int y = 0; y < sheet.height; ++y) {
    for (int x = 0; x < sheet.width; ++x) {
      const bool gap = x % (10 + kSheetGap) >= 10 || y % (6 + kSheetGap) >= 6;
      const int cell = 1 + x / (10 + kSheetGap) + 3 * (y / (6 + kSheetGap));
      ASSERT_EQ(redAt(sheet, x, y), gap ? 255 : cell) << x << ", " << y;
    }
  }
}

TEST(ContactSheet, OfNothingIsEmpty) {
  EXPECT_TRUE(arranged({}).rgba.empty());
  EXPECT_TRUE(arranged({{}}).rgba.empty());
}

TEST(ContactSheet, TheWorstFramesAreNotNeighbours) {
  const std::vector<double> psnr_db = {30, 20, 19, 21, 40, 25, 24, 26, 22};
  EXPECT_EQ(worstFrames(psnr_db, 3, 3), (std::vector<std::size_t>{2, 8, 5}));
  EXPECT_EQ(worstFrames(psnr_db, 3, 1), (std::vector<std::size_t>{2, 1, 3}));
}

TEST(ContactSheet, FewFramesThatAreFarEnoughApartMakeFewRows) {
  EXPECT_EQ(worstFrames(std::vector<double>{5, 4}, 4, 2), (std::vector<std::size_t>{1}));
  EXPECT_TRUE(worstFrames({}, 4, 2).empty());
}

TEST(ContactSheet, DifferencesAreAmplifiedUpToWhiteAndOpaque) {
  const Image difference = amplifiedDifference(uniform(2, 2, 100), uniform(2, 2, 90), 4);
  EXPECT_EQ(difference.rgba[0], 40);
  EXPECT_EQ(difference.rgba[3], 255);
  EXPECT_EQ(redAt(amplifiedDifference(uniform(2, 2, 0), uniform(2, 2, 90), 4), 1, 1), 255);
  EXPECT_EQ(redAt(amplifiedDifference(uniform(2, 2, 7), uniform(2, 2, 7), 4), 1, 1), 0);
}

TEST(ContactSheet, ShrinkingTakesTheMeanOfSquares) {
  Image image = uniform(5, 4, 10);
  image.rgba[0] = 50;  // of the first square of 2 × 2: (50 + 3 · 10) / 4
  const Image small = shrunk(image, 2);
  ASSERT_EQ(small.width, 2);
  ASSERT_EQ(small.height, 2);
  EXPECT_EQ(redAt(small, 0, 0), 20);
  EXPECT_EQ(redAt(small, 1, 1), 10);
  EXPECT_EQ(small.rgba[3], 255);
  EXPECT_EQ(shrunk(image, 1).rgba, image.rgba);
}

}  // namespace
}  // namespace enfilade
