#include "ibr/reference_image.h"

#include <gtest/gtest.h>

#include <cstring>

#include "analytic_scene.h"
#include "ibr/ldi_file.h"
#include "ibr/warp.h"
#include "plain_warp.h"
#include "random_cameras.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

PlanarCamera cameraAt(double angle, int rows) {
  ImageParameters parameters;
  parameters.image_size = rows;
  const glm::dvec3 at(1.5 * std::sin(angle), 1.6, 1.5 * std::cos(angle));
  return portalCamera(testing::doorway(), true, at, parameters);
}

DepthImage roomFrom(double angle, int rows = 128) {
  return testing::castImage(testing::furnishedRoom(), cameraAt(angle, rows));
}

std::vector<glm::vec2> doorwayIn(const PlanarCamera& desired) {
  std::vector<glm::vec2> region;
  for (const glm::vec3& corner : testing::doorway().polygon) {
    region.emplace_back(projectPoint(desired, glm::dvec3(corner)));
  }
  return region;
}

TEST(ReferenceImage, WarpedBackToItsOwnViewpointIsItsOwnPicture) {
  for (const double angle : {-1.2, 0.0, 0.7}) {
    const DepthImage image = roomFrom(angle);
    const Ldi reference = referenceImage(image);
    WarpBuffer buffer;
    buffer.resize(image.camera.width, image.camera.height);
    const WarpCounts counts =
        warpLdi(reference, image.camera, testing::wholePicture(image.camera), buffer);
    EXPECT_EQ(counts.pixels_uncovered, 0u);
    std::size_t same = 0;
    for (std::size_t i = 0; i < image.color.rgba.size(); i += 4) {
      same += std::equal(&image.color.rgba[i], &image.color.rgba[i + 4], &buffer.color.rgba[i]);
    }
    // What is a pixel wide between two of one nearer surface is taken for a crack.
    EXPECT_GT(static_cast<double>(same), 0.99 * static_cast<double>(counts.pixels));
  }
}

TEST(ReferenceImage, HasASampleForEachPixelWhereItsRayMeetsTheScene) {
  const DepthImage image = roomFrom(0.4);
  const Ldi reference = referenceImage(image);
  EXPECT_EQ(reference.samples.size(), image.disparity.size());
  EXPECT_EQ(samplesPerLayer(reference).size(), 1u);
  for (const LdiTile& tile : reference.tiles) {
    for (const LdiSample& s : std::span(reference.samples).subspan(tile.first, tile.count)) {
      const glm::dvec3 place = testing::storedPlace(tile, s);
      const std::size_t pixel =
          static_cast<std::size_t>(place.y) * static_cast<std::size_t>(image.camera.width) +
          static_cast<std::size_t>(place.x);
      ASSERT_EQ(place.x - std::floor(place.x), 0.5);
      ASSERT_EQ(place.y - std::floor(place.y), 0.5);
      ASSERT_NEAR(place.z, static_cast<double>(image.disparity[pixel]), 0.51 / (1 << 18));
      ASSERT_EQ(footprintSize(s.footprint >> 4), 1.0f);
      ASSERT_EQ(s.g, image.color.rgba[4 * pixel + 1]);
    }
  }
}

TEST(ReferenceImage, WarpsAsItsPointsProjectInDoublePrecision) {
  testing::Random random(61);
  std::size_t pixels = 0, differing = 0;
  for (int i = 0; i < 6; ++i) {
    const Ldi reference = referenceImage(roomFrom(random(-1.3, 1.3), 48));
    const double angle = random(-1.2, 1.2), distance = random(1.5, 4.0);
    const PlanarCamera desired = testing::desiredCamera(
        {distance * std::sin(angle), 1.6, distance * std::cos(angle)}, {0, 1, 0}, 96, 80);
    WarpBuffer buffer;
    buffer.resize(96, 80);
    warpLdi(reference, desired, testing::wholePicture(desired), buffer);
    const auto plain = testing::warpPlainly(
        reference, desired, std::vector<bool>(std::size_t{96 * 80}, true), Splat::kMean);
    for (std::size_t p = 0; p < plain.size(); ++p) {
      const std::uint8_t* rgba = &buffer.color.rgba[4 * p];
      bool same = (rgba[3] != 0) == plain[p].shown;
      for (int c = 0; c < 3 && plain[p].shown; ++c) {
        same = same && std::abs(rgba[c] - plain[p].color[c]) < 2.0;
      }
      pixels += plain[p].shown;
      differing += !same;
    }
  }
  EXPECT_GT(pixels, 3000u);
  EXPECT_LE(differing, pixels / 200);
}

TEST(ReferenceImage, TwoLeaveLessUncoveredThanEither) {
  const Ldi left = referenceImage(roomFrom(-0.785));
  const Ldi right = referenceImage(roomFrom(-0.262));
  const PlanarCamera desired = testing::desiredCamera({-1.3, 1.6, 2.2}, {0, 1, 0}, 160, 128);
  WarpBuffer buffer;
  buffer.resize(160, 128);
  const auto uncovered = [&](std::initializer_list<const Ldi*> images) {
    return warpImages(std::span(images.begin(), images.size()), desired, doorwayIn(desired), buffer)
        .pixels_uncovered;
  };
  const std::size_t both = uncovered({&left, &right});
  EXPECT_LT(both, uncovered({&left}));
  EXPECT_LT(both, uncovered({&right}));
}

TEST(ReferenceImage, LeavesOutWhereNothingIsKnown) {
  DepthImage image = roomFrom(0);
  std::fill(image.disparity.begin(), image.disparity.begin() + 40 * image.camera.width, 0.0f);
  const Ldi reference = referenceImage(image);
  EXPECT_EQ(reference.samples.size(),
            image.disparity.size() - 40 * static_cast<std::size_t>(image.camera.width));
  EXPECT_EQ(reference.tiles.front().y, 2);
  std::fill(image.disparity.begin(), image.disparity.end(), 0.0f);
  EXPECT_TRUE(referenceImage(image).tiles.empty());
}

TEST(ReferenceImage, IsAFileLikeAnyLayeredDepthImage) {
  TemporaryFolder here;
  const Ldi reference = referenceImage(roomFrom(0.2, 50));  // no multiple of a tile
  writeLdi(here / "reference-00.bin", reference);
  const Ldi again = readLdi(here / "reference-00.bin");
  ASSERT_EQ(again.samples.size(), reference.samples.size());
  EXPECT_EQ(std::memcmp(again.samples.data(), reference.samples.data(), 8 * again.samples.size()),
            0);
}

}  // namespace
}  // namespace enfilade
