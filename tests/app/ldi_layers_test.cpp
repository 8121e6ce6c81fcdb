#include "app/ldi_layers.h"

#include <gtest/gtest.h>

#include "scene/error.h"

namespace enfilade {
namespace {

/// Pixel (20, 3) has three layers, (33, 18) one.
Ldi smallLdi() {
  Ldi ldi;
  ldi.camera.width = 48;
  ldi.camera.height = 32;
  const auto sample = [](float x, float y, float disparity, std::uint8_t r) {
    return LdiSample{r, 0, 0, 0, packPlace(x, y, disparity)};
  };
  ldi.samples = {sample(4.5f, 3.5f, 0.2f, 3), sample(4.1f, 3.9f, 0.5f, 2),
                 sample(4.9f, 3.0f, 0.9f, 1), sample(1.5f, 2.5f, 0.6f, 4)};
  ldi.tiles = {{1, 0, 0, 3}, {2, 1, 0, 1}};
  indexTiles(ldi);
  return ldi;
}

TEST(LayerPicture, HoldsTheSamplesOfItsLayerAndNothingElse) {
  const Ldi ldi = smallLdi();
  for (std::size_t layer = 1; layer <= 3; ++layer) {
    const Image picture = layerPicture(ldi, layer, "");
    ASSERT_EQ(picture.width, 14);
    ASSERT_EQ(picture.height, 16);
    for (int y = 0; y < 16; ++y) {
      for (int x = 0; x < 14; ++x) {
        const auto layers = layersAt(ldi, x + 20, y + 3);
        const std::uint8_t* rgba = &picture.rgba[static_cast<std::size_t>(4 * (14 * y + x))];
        EXPECT_EQ(rgba[3], layers.size() >= layer ? 255 : 0) << x << "," << y;
        if (layers.size() >= layer) {
          EXPECT_EQ(rgba[0], layers[layer - 1].r);
        }
      }
    }
  }
}

TEST(LayerPicture, RefusesAnImageThatIsTooWide) {
  Ldi ldi = smallLdi();
  ldi.camera.width = ldi.camera.height = 1'000'000;
  ldi.tiles[1].x = ldi.tiles[1].y = 60'000;
  indexTiles(ldi);
  try {
    layerPicture(ldi, 1, "ldi.bin");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_TRUE(std::string(error.what()).starts_with("ldi.bin: is 959982 x 960000 pixels"))
        << error.what();
  }
}

const std::vector<SideLayers> kSides = {
    {2, true, {10, 5}}, {2, false, {20, 5, 3}}, {4, true, {1, 1, 1, 1, 1}}};

TEST(ChooseSide, TakesTheOneWithTheMostSamplesOfThoseThatMayBe) {
  EXPECT_EQ(&chooseSide(kSides, -1, ""), &kSides[1]);
  EXPECT_EQ(&chooseSide(kSides, -1, "front"), &kSides[0]);
  EXPECT_EQ(&chooseSide(kSides, 2, ""), &kSides[1]);
  EXPECT_EQ(&chooseSide(kSides, 4, ""), &kSides[2]);
  EXPECT_THROW(chooseSide(kSides, 4, "back"), Error);
  EXPECT_THROW(chooseSide(kSides, 3, ""), Error);
}

TEST(LayersText, AddsUpTheSidesAndTheDeepLayers) {
  EXPECT_EQ(samplesInAll(kSides), (std::vector<std::size_t>{31, 11, 4, 1, 1}));
  const std::string text = layersText(kSides);
  const std::string last = text.substr(text.rfind("\n  all"));
  // 48 in all: 31, 11, 4 and 2.
  for (const char* part : {" 48 ", " 64.6 %", " 22.9 %", " 8.3 %", " 2   4.2 %", " 5\n"}) {
    EXPECT_NE(last.find(part), std::string::npos) << part << " in " << last;
  }
}

}  // namespace
}  // namespace enfilade
