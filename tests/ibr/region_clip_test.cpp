#include "ibr/region_clip.h"

#include <gtest/gtest.h>

#include "ibr/clip_columns.h"
#include "ibr/warp.h"
#include "random_cameras.h"

namespace enfilade {
namespace {

using testing::Random;

/// The pixels of `polygon` that splats of `tile`'s samples touch, found by warping it alone.
ScreenBox pixelsTouched(const Ldi& ldi, const LdiTile& tile, const PlanarCamera& desired,
                        std::span<const glm::vec2> polygon, Splat splat) {
  Ldi alone;
  alone.camera = ldi.camera;
  alone.tiles = {tile};
  const auto first = ldi.samples.begin() + tile.first;
  alone.samples.assign(first, first + tile.count);
  indexTiles(alone);
  WarpBuffer buffer;
  buffer.resize(desired.width, desired.height);
  warpLdi(alone, desired, polygon, buffer, {splat, Clip::kNothing});
  ScreenBox box{1e9f, 1e9f, -1e9f, -1e9f};
  for (std::size_t p = 0; p < buffer.color.rgba.size() / 4; ++p) {
    if (buffer.color.rgba[4 * p + 3] > 0) {
      const auto x = static_cast<float>(p % static_cast<std::size_t>(desired.width));
      const auto y = static_cast<float>(p / static_cast<std::size_t>(desired.width));
      box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x + 1),
             std::max(box.bottom, y + 1)};
    }
  }
  return box;
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

/// Whether every pixel centre of `inner` lies in `outer`.
bool holds(const ScreenBox& outer, const ScreenBox& inner) {
  return outer.left <= inner.left + 0.5f && outer.top <= inner.top + 0.5f &&
         outer.right >= inner.right - 0.5f && outer.bottom >= inner.bottom - 0.5f;
}

PlanarCamera randomView(Random& random) {
  return testing::desiredCamera({random(-3.0, 3.0), random(0.0, 3.0), random(-2.0, 5.0)},
                                {random(-1.0, 1.0), random(0.0, 2.0), random(-3.0, 1.0)}, 100, 80);
}

TEST(RegionClip, NeverLeavesOutATileThatTouchesTheRegion) {
  Random random(21);
  int kept = 0, left_out = 0, touching = 0;
  for (int view = 0; view < 42; ++view) {
    const Splat splat = allSplats()[static_cast<std::size_t>(view) % 7].splat;
    const Ldi ldi = testing::randomLdi(random, 1500);
    const PlanarCamera desired = randomView(random);
    const std::vector<glm::vec2> region = randomRegion(random);
    const RegionClip clip(region, splat);
    const WarpTransform transform = warpTransform(ldi.camera, desired);
    for (const LdiTile& tile : ldi.tiles) {
      const ScreenBox reached = clip.reached(boxOf(tile), tileTransform(transform, tile));
      const ScreenBox touched = pixelsTouched(ldi, tile, desired, region, splat);
      ++(reached.empty() ? left_out : kept);
      if (!touched.empty()) {
        ++touching;
        ASSERT_TRUE(holds(reached, touched)) << infoOf(splat).name;
      }
    }
  }
  // And it does leave out much of what it could.
  EXPECT_GT(touching, 200);
  EXPECT_GT(2 * left_out, kept);
}

TEST(RegionClip, LeavesOutNoColumnThatHoldsATileThatTouchesTheRegion) {
  Random random(23);
  int kept = 0, left_out = 0;
  for (int view = 0; view < 40; ++view) {
    const Ldi ldi = testing::randomLdi(random, 1500);
    const PlanarCamera desired = randomView(random);
    const std::vector<glm::vec2> region = randomRegion(random);
    const RegionClip clip(region, Splat::k3x3);
    const WarpTransform transform = warpTransform(ldi.camera, desired);
    std::vector<ScreenBox> boxes(ldi.tiles.size());
    clipByColumns(ldi, transform, clip, boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const ScreenBox touched = pixelsTouched(ldi, ldi.tiles[i], desired, region, Splat::k3x3);
      ++(boxes[i].empty() ? left_out : kept);
      if (!touched.empty()) {
        ASSERT_TRUE(holds(boxes[i], touched));
      }
      // What a column keeps out a tile does too.
      const ScreenBox reached =
          clip.reached(boxOf(ldi.tiles[i]), tileTransform(transform, ldi.tiles[i]));
      EXPECT_TRUE(!boxes[i].empty() || reached.empty());
    }
  }
  EXPECT_GT(left_out, kept / 10);
}

TEST(RegionClip, TakesRegionsWithMoreCornersThanItKeepsEdges) {
  std::vector<glm::vec2> circle;
  for (int i = 0; i < 200; ++i) {
    circle.emplace_back(50 + 30 * std::cos(0.0314159 * i), 40 + 30 * std::sin(0.0314159 * i));
  }
  Random random(22);
  const Ldi ldi = testing::randomLdi(random, 1500);
  const PlanarCamera desired = testing::desiredCamera({0.5, 1.5, 2.5}, {0, 1.2, 0}, 100, 80);
  const RegionClip clip(circle, Splat::kMean);
  const WarpTransform transform = warpTransform(ldi.camera, desired);
  for (const LdiTile& tile : ldi.tiles) {
    if (!pixelsTouched(ldi, tile, desired, circle, Splat::kMean).empty()) {
      EXPECT_FALSE(clip.reached(boxOf(tile), tileTransform(transform, tile)).empty());
    }
  }
}

}  // namespace
}  // namespace enfilade
