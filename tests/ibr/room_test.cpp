// A furnished room seen through a doorway: quality of the whole chain, captures by exact rays.
#include <gtest/gtest.h>

#include <cmath>

#include "analytic_scene.h"
#include "ibr/portal_capture.h"
#include "ibr/warp.h"
#include "random_cameras.h"

namespace enfilade {
namespace {

struct Quality {
  double psnr_db = 0;  ///< inside the portal's region alone; uncovered pixels count as black
  double uncovered_percent = 0;
  double open_percent = 0;  ///< uncovered and not closed as a crack
};

/// Warps `ldi` to `desired` and compares the doorway's region with exact rays.
Quality compare(const testing::AnalyticScene& room, const Ldi& ldi, const PlanarCamera& desired) {
  std::vector<glm::vec2> region;
  for (const glm::vec3& corner : testing::doorway().polygon) {
    region.emplace_back(projectPoint(desired, glm::dvec3(corner)));
  }
  WarpBuffer buffer;
  buffer.resize(desired.width, desired.height);
  const WarpCounts counts = warpLdi(ldi, desired, region, buffer);
  const DepthImage truth = testing::castThroughDoorway(room, desired, region);
  double error = 0;
  std::size_t pixels = 0;
  for (std::size_t p = 0; p < truth.disparity.size(); ++p) {
    if (truth.disparity[p] > 0) {
      ++pixels;
      for (std::size_t c = 0; c < 3; ++c) {
        const double off = double{1} * buffer.color.rgba[4 * p + c] - truth.color.rgba[4 * p + c];
        error += off * off;
      }
    }
  }
  EXPECT_EQ(pixels, counts.pixels);
  const auto n = static_cast<double>(pixels);
  return {10 * std::log10(255.0 * 255.0 * 3 * n / error),
          100 * static_cast<double>(counts.pixels_uncovered) / n,
          100 * static_cast<double>(counts.pixels_uncovered - counts.pixels_bridged) / n};
}

/// The mean over views from anywhere beyond the switch distance.
Quality meanQuality(const testing::AnalyticScene& room, const Ldi& ldi) {
  testing::Random random(41);
  constexpr int kViews = 10;
  Quality mean;
  for (int i = 0; i < kViews; ++i) {
    const double angle = glm::radians(random(-72.0, 72.0));
    const double distance = random(1.6, 5.0);
    const PlanarCamera desired = testing::desiredCamera(
        {distance * std::sin(angle), random(1.45, 1.8), distance * std::cos(angle)},
        {random(-0.3, 0.3), random(0.9, 1.4), 0}, 320, 256);
    const Quality q = compare(room, ldi, desired);
    mean.psnr_db += q.psnr_db / kViews;
    mean.uncovered_percent += q.uncovered_percent / kViews;
    mean.open_percent += q.open_percent / kViews;
  }
  return mean;
}

Ldi roomLdi(const testing::AnalyticScene& room, const ImageParameters& parameters) {
  return buildLdi(testing::doorway(), true, 1.6f, parameters,
                  [&](const PlanarCamera& camera) { return testing::castImage(room, camera); });
}

TEST(Room, LooksThroughTheDoorwayAsExactRaysSeeIt) {
  const testing::AnalyticScene room = testing::furnishedRoom();
  ImageParameters parameters;
  parameters.image_size = 192;  // for pictures of 256 rows what 384 are for 512
  parameters.portal_margin = 0;
  const Quality rings = meanQuality(room, roomLdi(room, parameters));
  EXPECT_GT(rings.psnr_db, 22.5);
  EXPECT_LT(rings.uncovered_percent, 1.5);
  EXPECT_LT(rings.open_percent, 0.5);

  // A reference image alone leaves what it does not see.
  parameters.rings = {{1, 0.0f, 0.0f}};
  const Quality one = meanQuality(room, roomLdi(room, parameters));
  EXPECT_GT(one.open_percent, 20 * rings.open_percent);
  EXPECT_LT(one.psnr_db, rings.psnr_db - 6);
}

TEST(Room, IsSeenWithoutHolesFromTheCentralViewpoint) {
  // From where the central image was taken, at its own pixels: what differs is mixed in by others.
  const testing::AnalyticScene room = testing::furnishedRoom();
  ImageParameters parameters;
  parameters.image_size = 96;
  parameters.portal_margin = 0;
  parameters.rays = 1;
  const Ldi ldi = roomLdi(room, parameters);
  const glm::dvec3 center = captureViewpoints(testing::doorway(), true, 1.6f, parameters)[0];
  const PlanarCamera camera = portalCamera(testing::doorway(), true, center, parameters);
  const Quality q = compare(room, ldi, camera);
  EXPECT_EQ(q.uncovered_percent, 0.0);
  EXPECT_GT(q.psnr_db, 31.0);
}

}  // namespace
}  // namespace enfilade
