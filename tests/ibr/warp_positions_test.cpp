#include "ibr/warp_positions.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_cameras.h"

namespace enfilade {
namespace {

using testing::Random;

/// Calls check(sample's place, batch, index in it) for every sample of `ldi` warped to `desired`.
template <class Check>
void forEachWarped(const Ldi& ldi, const PlanarCamera& desired, Check&& check) {
  const WarpTransform transform = warpTransform(ldi.camera, desired);
  for (const LdiTile& tile : ldi.tiles) {
    const TileTransform tile_transform = tileTransform(transform, tile);
    for (std::uint32_t at = 0; at < tile.count; at += kWarpBatch) {
      const auto samples =
          std::span(ldi.samples)
              .subspan(tile.first + at, std::min<std::size_t>(kWarpBatch, tile.count - at));
      WarpedBatch batch;
      warpBatch(tile_transform, samples, batch);
      for (std::size_t i = 0; i < samples.size(); ++i) {
        check(testing::storedPlace(tile, samples[i]), samples[i], batch, i);
      }
    }
  }
}

TEST(WarpTransform, AgreesWithProjectingThePoint) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const PlanarCamera from = testing::referenceCamera(64);
    const PlanarCamera to =
        testing::desiredCamera({random(-3.0, 3.0), random(0.5, 2.5), random(0.2, 6.0)},
                               {random(-1.0, 1.0), random(0.0, 2.0), -1}, 640, 512);
    const glm::dvec3 place(random(-50.0, 100.0), random(-50.0, 100.0), random(0.001, 1.0));
    const glm::dvec3 h = warpTransform(from, to).homogeneous(place.x, place.y, place.z);
    const glm::dvec3 truth = projectPoint(to, unprojectPoint(from, place));
    EXPECT_NEAR(h.x / h.z, truth.x, 1e-6 * (1 + std::abs(truth.x)));
    EXPECT_NEAR(h.y / h.z, truth.y, 1e-6 * (1 + std::abs(truth.y)));
    EXPECT_NEAR(place.z / h.z, truth.z, 1e-9 * (1 + std::abs(truth.z)));
  }
}

TEST(WarpBatch, AgreesWithProjectingEverySamplesPointToAHundredthOfAPixel) {
  Random random(2);
  std::size_t compared = 0;
  for (int view = 0; view < 60; ++view) {
    const Ldi ldi = testing::randomLdi(random, 3000);
    const double distance = random(0.3, 6.0);
    const double angle = random(-1.4, 1.4);
    const PlanarCamera desired = testing::desiredCamera(
        {distance * std::sin(angle), random(0.8, 2.2), distance * std::cos(angle)},
        {random(-0.5, 0.5), random(0.3, 1.8), 0}, 640, 512);
    forEachWarped(
        ldi, desired,
        [&](const glm::dvec3& place, const LdiSample&, const WarpedBatch& batch, std::size_t i) {
          const glm::dvec3 truth = projectPoint(desired, unprojectPoint(ldi.camera, place));
          if (truth.z <= 0.0) {
            EXPECT_LE(batch.disparity[i], 0.0f);
            return;
          }
          const bool on_screen = truth.x > -64 && truth.x < 704 && truth.y > -64 && truth.y < 576;
          if (on_screen) {
            EXPECT_NEAR(static_cast<double>(batch.disparity[i]) / truth.z, 1.0, 1e-4);
            EXPECT_NEAR(static_cast<double>(batch.x[i]), truth.x, 0.01);
            EXPECT_NEAR(static_cast<double>(batch.y[i]), truth.y, 0.01);
            ++compared;
          }
        });
  }
  EXPECT_GT(compared, 20000u);
}

TEST(WarpBatch, AgreesAlsoFarOutInAWideWindowOfManyPixels) {
  // 4096 rows, samples tens of thousands of pixels beside the middle.
  Random random(3);
  LdiBuilder builder(testing::referenceCamera(4096), {0.0f, 16.0f});
  CaptureSamples capture{testing::referenceCamera(4096), {}};
  for (int i = 0; i < 5000; ++i) {
    CaptureSample s;
    s.u = static_cast<float>(random(-15000.0, 17000.0));
    s.v = static_cast<float>(random(-30000.0, 30000.0));
    s.disparity = static_cast<float>(random(0.002, 0.5));
    capture.samples.push_back(s);
  }
  builder.insert(capture);
  const Ldi ldi = builder.finish();
  ASSERT_GT(ldi.samples.size(), 4000u);
  const PlanarCamera desired = testing::desiredCamera({2.5, 1.7, 0.8}, {-1, 1, -1}, 640, 512);
  std::size_t compared = 0;
  forEachWarped(
      ldi, desired,
      [&](const glm::dvec3& place, const LdiSample&, const WarpedBatch& batch, std::size_t i) {
        const glm::dvec3 truth = projectPoint(desired, unprojectPoint(ldi.camera, place));
        if (truth.z > 0 && truth.x > 0 && truth.x < 640 && truth.y > 0 && truth.y < 512) {
          EXPECT_NEAR(static_cast<double>(batch.x[i]), truth.x, 0.01);
          EXPECT_NEAR(static_cast<double>(batch.y[i]), truth.y, 0.01);
          ++compared;
        }
      });
  EXPECT_GT(compared, 100u);
}

TEST(WarpBatch, GivesTheBoxOfTheFootprintsImage) {
  Random random(4);
  const Ldi ldi = testing::randomLdi(random, 2000);
  const PlanarCamera desired = testing::desiredCamera({1.2, 1.5, 1.8}, {0, 1.2, -1}, 640, 512);
  forEachWarped(
      ldi, desired,
      [&](const glm::dvec3& place, const LdiSample& sample, const WarpedBatch& batch,
          std::size_t i) {
        const auto at = [&](double du, double dv) {
          return projectPoint(desired, unprojectPoint(ldi.camera, place + glm::dvec3(du, dv, 0)));
        };
        if (at(0, 0).z <= 0) {
          return;
        }
        const double e = 1e-4;
        const double across = static_cast<double>(footprintSize(sample.footprint >> 4));
        const double down = static_cast<double>(footprintSize(sample.footprint & 15u));
        const glm::dvec3 per_u = (at(e, 0) - at(-e, 0)) / (2 * e);
        const glm::dvec3 per_v = (at(0, e) - at(0, -e)) / (2 * e);
        const double half_width = 0.5 * (std::abs(per_u.x) * across + std::abs(per_v.x) * down);
        const double half_height = 0.5 * (std::abs(per_u.y) * across + std::abs(per_v.y) * down);
        EXPECT_NEAR(static_cast<double>(batch.half_width[i]), half_width, 2e-3 * (1 + half_width));
        EXPECT_NEAR(static_cast<double>(batch.half_height[i]), half_height,
                    2e-3 * (1 + half_height));
      });
}

}  // namespace
}  // namespace enfilade
