#include "ibr/ldi.h"

#include <gtest/gtest.h>

#include <random>

namespace enfilade {
namespace {

TEST(LdiSample, KeepsItsPlaceToASixteenthOfAPixelAndInItsPixel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> place(0, 16), disparity(1e-5f, 1);
  for (int i = 0; i < 10000; ++i) {
    const float x = place(random), y = place(random), d = disparity(random);
    LdiSample s;
    s.place = packPlace(x, y, d);
    EXPECT_EQ(std::floor(xInTile(s)), std::min(std::floor(x), 15.0f));
    EXPECT_EQ(std::floor(yInTile(s)), std::min(std::floor(y), 15.0f));
    EXPECT_NEAR(xInTile(s), x, 0.1251f);  // 1/16, and 1/8 at a pixel's right edge
    EXPECT_NEAR(yInTile(s), y, 0.1251f);
    EXPECT_NEAR(disparityOf(s), d, 0.5f / (1 << 18) + 1e-7f + std::max(0.0f, 1.0f / (1 << 18) - d));
  }
}

TEST(LdiSample, KeepsAPixelsCentreAndTheImagePlaneExactly) {
  LdiSample s;
  s.place = packPlace(7.5f, 0.5f, 1.0f);
  EXPECT_EQ(xInTile(s), 7.5f);
  EXPECT_EQ(yInTile(s), 0.5f);
  EXPECT_EQ(disparityOf(s), 1.0f);
}

TEST(LdiSample, ClampsWhatCannotBeStored) {
  LdiSample s;
  s.place = packPlace(16.0f, -0.1f, 1.5f);
  EXPECT_EQ(xInTile(s), 15.875f);
  EXPECT_EQ(yInTile(s), 0.0f);
  EXPECT_EQ(disparityOf(s), 1.0f);
  s.place = packPlace(3.0f, 3.0f, 0.0f);
  EXPECT_GT(disparityOf(s), 0.0f);
}

TEST(LdiSample, ComparesByPlaceAsByDisparity) {
  EXPECT_LT(packPlace(15.9f, 15.9f, 0.3f), packPlace(0.0f, 0.0f, 0.31f));
}

TEST(LdiSample, StoresItsFootprintNoSmallerThanItIsByAFactorOfRootTwoAtMost) {
  EXPECT_EQ(footprintSize(packFootprint(1, 1) >> 4), 1.0f);
  EXPECT_EQ(footprintSize(packFootprint(1, 1) & 15u), 1.0f);
  for (float size = 0.25f; size < 45.0f; size *= 1.07f) {
    const float across = footprintSize(packFootprint(size, 1) >> 4);
    EXPECT_GE(across, 0.99f * size);
    EXPECT_LE(across, 1.4143f * size);
    EXPECT_EQ(packFootprint(size, 3.0f) & 15, packFootprint(0.5f, 3.0f) & 15);
  }
  EXPECT_EQ(footprintSize(packFootprint(0.0f, 0.0f) >> 4), 0.25f);
  EXPECT_NEAR(footprintSize(packFootprint(1e9f, 0.0f) >> 4), 45.25f, 0.01f);
}

/// Two tiles: three samples at pixel (2, 3), one at (5, 3), one at (18, 3).
Ldi smallLdi() {
  Ldi ldi;
  ldi.camera.width = 40;
  ldi.camera.height = 20;
  const auto sample = [](float x, float y, float d, std::uint8_t r) {
    return LdiSample{r, 0, 0, 0, packPlace(x, y, d)};
  };
  ldi.samples = {sample(2.5f, 3.5f, 0.2f, 1), sample(2.1f, 3.9f, 0.5f, 2),
                 sample(5.5f, 3.5f, 0.6f, 3), sample(2.9f, 3.0f, 0.9f, 4),
                 sample(2.0f, 3.5f, 0.4f, 5)};
  ldi.tiles.resize(2);
  ldi.tiles[0].count = 4;
  ldi.tiles[1].x = 1;
  ldi.tiles[1].count = 1;
  indexTiles(ldi);
  return ldi;
}

TEST(Ldi, TellsThePixelsLayersNearestFirst) {
  const Ldi ldi = smallLdi();
  const std::vector<LdiSample> layers = layersAt(ldi, 2, 3);
  ASSERT_EQ(layers.size(), 3u);
  EXPECT_EQ(layers[0].r, 4);
  EXPECT_EQ(layers[1].r, 2);
  EXPECT_EQ(layers[2].r, 1);
  EXPECT_EQ(layersAt(ldi, 18, 3).at(0).r, 5);
  EXPECT_TRUE(layersAt(ldi, 3, 3).empty());
  EXPECT_TRUE(layersAt(ldi, 39, 19).empty());
  EXPECT_EQ(samplesPerLayer(ldi), (std::vector<std::size_t>{3, 1, 1}));
}

TEST(Ldi, IndexesItsTiles) {
  const Ldi ldi = smallLdi();
  EXPECT_EQ(ldi.row_tiles, (std::vector<std::uint32_t>{0, 2, 2}));
  EXPECT_EQ(ldi.tiles[1].first, 4u);
  EXPECT_NEAR(ldi.tiles[0].least_disparity, 0.2f, 1e-5f);
  EXPECT_NEAR(ldi.tiles[0].greatest_disparity, 0.9f, 1e-5f);
}

}  // namespace
}  // namespace enfilade
