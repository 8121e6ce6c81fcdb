#include "ibr/ldi_builder.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

/// Looks through the square of 32 cm around the origin in the plane z = 0.
PlanarCamera cameraAt(const glm::dvec3& center, int pixels) {
  PlanarCamera camera;
  camera.center = center;
  camera.world_from_pixel = glm::dmat3({0.32 / pixels, 0, 0}, {0, -0.32 / pixels, 0},
                                       glm::dvec3(-0.16, 0.16, 0) - center);
  camera.width = camera.height = pixels;
  return camera;
}

const PlanarCamera kCentral = cameraAt({0, 0, 2}, 32);
const PlanarCamera kAside = cameraAt({1, 0, 2}, 32);
const PlanarCamera kFiner = cameraAt({0, 0, 1}, 128);

/// One pixel of slack: samples up to 0.01 / 2 apart in disparity show one surface.
constexpr float kThreshold = 0.005f;

/// A capture with one sample: the point at pixel (x, y) and disparity `disparity` of the central
/// view, coloured `color`, that `camera` saw.
CaptureSamples sees(const PlanarCamera& camera, double x, double y, double disparity,
                    std::uint8_t color) {
  const glm::dvec3 seen = projectPoint(camera, unprojectPoint(kCentral, {x, y, disparity}));
  CaptureSample sample;
  sample.u = static_cast<float>(seen.x);
  sample.v = static_cast<float>(seen.y);
  sample.disparity = static_cast<float>(seen.z);
  sample.r = color;
  return {camera, {sample}};
}

CaptureSamples nothing(const PlanarCamera& camera) { return {camera, {}}; }

Ldi built(const std::vector<CaptureSamples>& captures) {
  LdiBuilder builder(kCentral, {1.0f, 4.0f});
  for (const CaptureSamples& capture : captures) {
    builder.insert(capture);
  }
  return builder.finish();
}

/// The colours of the layers of pixel (7, 9) of the central view.
std::vector<int> layers(const std::vector<CaptureSamples>& captures) {
  std::vector<int> colors;
  const Ldi ldi = built(captures);
  const glm::dvec3 corner = projectPoint(ldi.camera, unprojectPoint(kCentral, {0, 0, 1}));
  for (const LdiSample& s : layersAt(ldi, 7 + static_cast<int>(std::lround(corner.x)),
                                     9 + static_cast<int>(std::lround(corner.y)))) {
    colors.push_back(s.r);
  }
  return colors;
}

using Colors = std::vector<int>;

TEST(LdiBuilder, SeparatesDisparitiesThatWouldMoveAPixel) {
  EXPECT_NEAR(disparityThreshold(kCentral, 1.0f), kThreshold, 1e-6f);
  EXPECT_NEAR(disparityThreshold(kCentral, 0.5f), 0.5f * kThreshold, 1e-6f);
}

TEST(LdiBuilder, KeepsTheCentralImageWhenABetterSampleMeetsIt) {
  const auto central = sees(kCentral, 7.5, 9.5, 0.5, 1);
  const auto better = sees(kFiner, 7.4, 9.4, 0.501, 2);
  EXPECT_LT(patchArea(kFiner, better.samples[0]), patchArea(kCentral, central.samples[0]));
  EXPECT_EQ(layers({central, better}), (Colors{1}));
}

TEST(LdiBuilder, NeverDisplacesTheCentralImageFromLayerOne) {
  EXPECT_EQ(layers({sees(kCentral, 7.5, 9.5, 0.5, 1), sees(kAside, 7.5, 9.5, 0.7, 2)}),
            (Colors{1}));
}

TEST(LdiBuilder, KeepsTheCentralImagesSamplesWhereTheyWereSeen) {
  CaptureSamples central{kCentral, {}};
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      CaptureSample s;
      s.u = static_cast<float>(x) + 0.5f;
      s.v = static_cast<float>(y) + 0.5f;
      s.disparity = 0.4f;
      s.r = static_cast<std::uint8_t>(x);
      s.g = static_cast<std::uint8_t>(y);
      central.samples.push_back(s);
    }
  }
  CaptureSamples other = central;  // a plane at another depth for it, in part
  other.camera = kAside;
  for (CaptureSample& s : other.samples) {
    s.b = 255;
  }
  const Ldi ldi = built({central, other});
  const glm::dvec3 corner = projectPoint(ldi.camera, unprojectPoint(kCentral, {0, 0, 1}));
  for (int y = 0; y < 32; ++y) {
    for (int x = 0; x < 32; ++x) {
      const auto at = layersAt(ldi, x + static_cast<int>(std::lround(corner.x)),
                               y + static_cast<int>(std::lround(corner.y)));
      ASSERT_FALSE(at.empty());
      EXPECT_EQ(at[0].r, x);
      EXPECT_EQ(at[0].g, y);
      EXPECT_EQ(at[0].b, 0);
      EXPECT_EQ(xInTile(at[0]) - std::floor(xInTile(at[0])), 0.5f);
      EXPECT_EQ(footprintSize(at[0].footprint >> 4), 1.0f);
    }
  }
}

TEST(LdiBuilder, AddsASampleWhereItsPixelIsEmpty) {
  EXPECT_EQ(layers({nothing(kCentral), sees(kAside, 7.5, 9.5, 0.5, 2)}), (Colors{2}));
}

TEST(LdiBuilder, AddsALayerWhereNothingOfSimilarDepthStands) {
  const auto central = sees(kCentral, 7.5, 9.5, 0.5, 1);
  const double beyond = 0.5 - 1.2 * static_cast<double>(kThreshold);
  const double alike = 0.5 - 0.8 * static_cast<double>(kThreshold);
  EXPECT_EQ(layers({central, sees(kAside, 7.2, 9.2, beyond, 2)}), (Colors{1, 2}));
  EXPECT_EQ(layers({central, sees(kAside, 7.2, 9.2, alike, 2)}), (Colors{1}));
}

TEST(LdiBuilder, KeepsTheSmallerPatchOfTwoThatMeet) {
  // Whichever comes first.
  const auto coarse = sees(kAside, 7.5, 9.5, 0.5, 2);
  const auto fine = sees(kFiner, 7.4, 9.4, 0.501, 3);
  ASSERT_LT(patchArea(kFiner, fine.samples[0]), patchArea(kAside, coarse.samples[0]));
  EXPECT_EQ(layers({nothing(kCentral), coarse, fine}), (Colors{3}));
  EXPECT_EQ(layers({nothing(kCentral), fine, coarse}), (Colors{3}));
}

TEST(LdiBuilder, KeepsOneOfManyThatMeetABetterOne) {
  auto coarse = sees(kAside, 7.1, 9.1, 0.498, 2);
  coarse.samples.push_back(sees(kAside, 7.9, 9.9, 0.502, 3).samples[0]);
  EXPECT_EQ(layers({nothing(kCentral), coarse}), (Colors{3, 2}));
  EXPECT_EQ(layers({nothing(kCentral), coarse, sees(kFiner, 7.5, 9.5, 0.5, 4)}), (Colors{4}));
}

TEST(LdiBuilder, LetsADoubtfulSampleYield) {
  auto fine = sees(kFiner, 7.4, 9.4, 0.501, 3);
  fine.samples[0].doubt = 1000.0f;
  EXPECT_EQ(layers({nothing(kCentral), fine, sees(kAside, 7.5, 9.5, 0.5, 2)}), (Colors{2}));
}

TEST(LdiBuilder, KeepsTwoSamplesOfOneCapture) {
  auto both = sees(kAside, 7.2, 9.2, 0.5, 2);
  both.samples.push_back(sees(kAside, 7.8, 9.8, 0.5, 3).samples[0]);
  EXPECT_EQ(layers({nothing(kCentral), both}).size(), 2u);
  auto central = sees(kCentral, 7.2, 9.2, 0.5, 2);
  central.samples.push_back(sees(kCentral, 7.8, 9.8, 0.4, 3).samples[0]);
  EXPECT_EQ(layers({central}), (Colors{2, 3}));
}

TEST(LdiBuilder, KeepsLayersInDepthOrderInWhateverOrderTheyCome) {
  const auto a = sees(kAside, 7.5, 9.5, 0.5, 1);
  const auto b = sees(kFiner, 7.5, 9.5, 0.3, 2);
  const auto c = sees(kFiner, 7.5, 9.5, 0.7, 3);
  EXPECT_EQ(layers({nothing(kCentral), a, b, c}), (Colors{3, 1, 2}));
  EXPECT_EQ(layers({nothing(kCentral), b, c, a}), (Colors{3, 1, 2}));
}

TEST(LdiBuilder, HasAWindowAsWideAsItsSamplesNeedWithinTheLimit) {
  const Ldi narrow = built({sees(kCentral, 7.5, 9.5, 0.5, 1)});
  EXPECT_EQ(narrow.camera.width, 32);
  const Ldi wide = built({nothing(kCentral), sees(kAside, -40.0, 9.5, 0.5, 2)});
  EXPECT_EQ(wide.camera.width, 32 + 48);
  EXPECT_EQ(wide.camera.height, 32);
  EXPECT_EQ(wide.samples.size(), 1u);
  // Half width 16 pixels, four times that to either side of the middle.
  EXPECT_EQ(built({nothing(kCentral), sees(kAside, -100.0, 9.5, 0.5, 2)}).samples.size(), 0u);
}

TEST(LdiBuilder, StoresSamplesWhereTheirPointsAre) {
  const glm::dvec3 point(0.4, -0.3, -1.5);
  const glm::dvec3 central = projectPoint(kCentral, point);
  const Ldi ldi = built({nothing(kCentral), sees(kAside, central.x, central.y, central.z, 2)});
  ASSERT_EQ(ldi.samples.size(), 1u);
  const LdiTile& tile = ldi.tiles[0];
  const LdiSample& s = ldi.samples[0];
  const glm::dvec3 stored(tile.x * kLdiTile + static_cast<double>(xInTile(s)),
                          tile.y * kLdiTile + static_cast<double>(yInTile(s)),
                          static_cast<double>(disparityOf(s)));
  const glm::dvec3 again = projectPoint(ldi.camera, point);
  EXPECT_NEAR(stored.x, again.x, 0.126);
  EXPECT_NEAR(stored.y, again.y, 0.126);
  EXPECT_NEAR(stored.z, again.z, 3e-6);
}

TEST(LdiBuilder, LeavesOutWhatLiesBehindTheCentralViewpoint) {
  PlanarCamera ahead = kCentral;
  ahead.center = {0, 0, 5};
  ahead.world_from_pixel[2] = glm::dvec3(-0.16, 0.16, -1);
  CaptureSample s;
  s.u = s.v = 16;
  s.disparity = 0.5f;  // at z = 3, behind z = 2
  EXPECT_TRUE(built({nothing(kCentral), {ahead, {s}}}).samples.empty());
}

}  // namespace
}  // namespace enfilade
