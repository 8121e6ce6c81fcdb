#include "ibr/tile_clip.h"

#include <gtest/gtest.h>

#include "ibr/reconstruction.h"
#include "random_cameras.h"

namespace enfilade {
namespace {

using testing::Random;

/// Whether `ldi`'s samples in `tile` touch the region, and which rows, found one by one.
RowsReached rowsTouched(const Ldi& ldi, const LdiTile& tile, const PlanarCamera& desired,
                        std::span<const glm::vec2> polygon) {
  WarpBuffer buffer;
  buffer.resize(desired.width, desired.height);
  const RegionOfBuffer region = regionOf(polygon, buffer);
  clearRegion(region);
  const TileTransform transform = tileTransform(warpTransform(ldi.camera, desired), tile);
  for (std::uint32_t at = 0; at < tile.count; at += kWarpBatch) {
    const auto samples =
        std::span(ldi.samples)
            .subspan(tile.first + at, std::min<std::size_t>(kWarpBatch, tile.count - at));
    WarpedBatch batch;
    warpBatch(transform, samples, batch);
    addSamples(region, batch, samples);
  }
  RowsReached rows{1e9f, -1e9f};
  for (std::size_t p = 0; p < buffer.nearest.size(); ++p) {
    if (buffer.nearest[p] > 0) {
      const auto y = static_cast<float>(p / static_cast<std::size_t>(desired.width));
      rows.top = std::min(rows.top, y);
      rows.bottom = std::max(rows.bottom, y + 1);
    }
  }
  return rows;
}

std::vector<glm::vec2> randomRegion(Random& random) {
  const glm::vec2 middle(random(-20.0, 120.0), random(-20.0, 100.0));
  const glm::vec2 radii(random(5.0, 60.0), random(5.0, 60.0));
  const int corners = random(3, 8);
  std::vector<glm::vec2> polygon;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + random(0.0, 0.8)) * 6.2831853 / corners;
    polygon.push_back(middle + radii * glm::vec2(std::cos(angle), std::sin(angle)));
  }
  if (random(0, 2) == 0) {
    std::reverse(polygon.begin(), polygon.end());
  }
  return polygon;
}

TEST(TileClip, NeverLeavesOutATileThatTouchesTheRegion) {
  Random random(21);
  int kept = 0, left_out = 0, touching = 0;
  for (int view = 0; view < 40; ++view) {
    const Ldi ldi = testing::randomLdi(random, 1500);
    const PlanarCamera desired =
        testing::desiredCamera({random(-3.0, 3.0), random(0.0, 3.0), random(-2.0, 5.0)},
                               {random(-1.0, 1.0), random(0.0, 2.0), random(-3.0, 1.0)}, 100, 80);
    const std::vector<glm::vec2> region = randomRegion(random);
    const TileClip clip(region);
    const WarpTransform transform = warpTransform(ldi.camera, desired);
    for (const LdiTile& tile : ldi.tiles) {
      const RowsReached reached = clip.rowsReached(tile, tileTransform(transform, tile));
      const RowsReached touched = rowsTouched(ldi, tile, desired, region);
      ++(reached.empty() ? left_out : kept);
      if (!touched.empty()) {
        ++touching;
        ASSERT_FALSE(reached.empty());
        EXPECT_LE(reached.top, touched.top);
        EXPECT_GE(reached.bottom, touched.bottom - 1);  // a row counts from its centre
      }
    }
  }
  // And it does leave out most of what it could.
  EXPECT_GT(touching, 300);
  EXPECT_GT(left_out, kept);
}

TEST(TileClip, TakesRegionsWithMoreCornersThanItKeepsEdges) {
  std::vector<glm::vec2> circle;
  for (int i = 0; i < 200; ++i) {
    circle.emplace_back(50 + 30 * std::cos(0.0314159 * i), 40 + 30 * std::sin(0.0314159 * i));
  }
  Random random(22);
  const Ldi ldi = testing::randomLdi(random, 1500);
  const PlanarCamera desired = testing::desiredCamera({0.5, 1.5, 2.5}, {0, 1.2, 0}, 100, 80);
  const TileClip clip(circle);
  const WarpTransform transform = warpTransform(ldi.camera, desired);
  for (const LdiTile& tile : ldi.tiles) {
    if (!rowsTouched(ldi, tile, desired, circle).empty()) {
      EXPECT_FALSE(clip.rowsReached(tile, tileTransform(transform, tile)).empty());
    }
  }
}

}  // namespace
}  // namespace enfilade
