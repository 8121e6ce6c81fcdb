#include "ibr/warp.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "ibr/convex_region.h"
#include "plain_warp.h"
#include "random_cameras.h"
#include "render/thread_team.h"

namespace {
std::atomic<std::size_t> allocations{0};
}  // namespace

// The sanitizers have allocators of their own, also in libraries.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ENFILADE_OTHER_ALLOCATORS
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define ENFILADE_OTHER_ALLOCATORS
#endif

#ifndef ENFILADE_OTHER_ALLOCATORS
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) {
    return memory;
  }
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace enfilade {
namespace {

using testing::Random;

/// Which pixels of a picture lie in `polygon`.
std::vector<bool> pixelsIn(const std::vector<glm::vec2>& polygon, int width, int height) {
  std::vector<glm::ivec2> spans(static_cast<std::size_t>(height), glm::ivec2(0));
  const RowRange rows = fillConvexPolygon(polygon, width, height, spans);
  std::vector<bool> pixels(static_cast<std::size_t>(width * height));
  for (int y = rows.top; y < rows.bottom; ++y) {
    const glm::ivec2 span = spans[static_cast<std::size_t>(y)];
    for (int x = span.x; x < span.y; ++x) {
      pixels[static_cast<std::size_t>(y * width + x)] = true;
    }
  }
  return pixels;
}

/// A slanting wall, z = 0.8 x − 2.5, with a box before it, both with noise, seen by three captures.
Ldi wallAndBox(Random& random) {
  LdiBuilder builder(testing::referenceCamera(48), {0.5f, 8.0f});
  for (const double x : {0.0, -0.8, 0.8}) {
    PlanarCamera camera = testing::referenceCamera(48);
    camera.center.x += x;
    camera.world_from_pixel[2].x -= x;
    DepthImage picture;
    picture.camera = camera;
    for (int row = 0; row < camera.height; ++row) {
      for (int column = 0; column < camera.width; ++column) {
        const glm::dvec3 ray = camera.world_from_pixel * glm::dvec3(column + 0.5, row + 0.5, 1);
        const double to_wall = (0.8 * camera.center.x - 4.0) / (ray.z - 0.8 * ray.x);
        const double to_box = -2.3 / ray.z;
        const glm::dvec3 on_box = camera.center + to_box * ray;
        const bool box = std::abs(on_box.x) < 0.3 && std::abs(on_box.y - 1.0) < 0.4;
        picture.disparity.push_back(static_cast<float>(1.0 / (box ? to_box : to_wall)));
        for (int c = 0; c < 3; ++c) {
          picture.color.rgba.push_back(
              static_cast<std::uint8_t>(random(box ? 0 : 128, box ? 128 : 256)));
        }
        picture.color.rgba.push_back(255);
      }
    }
    builder.insert(resolveCapture(picture, 1, 0.005f));
  }
  return builder.finish();
}

struct Scene {
  Ldi ldi;
  PlanarCamera desired;
  std::vector<glm::vec2> region;  ///< the doorway, as seen
};

Scene randomView(Random& random, int width, int height) {
  Scene scene;
  scene.ldi = wallAndBox(random);
  const double distance = random(1.5, 4.0);
  const double angle = random(-1.2, 1.2);
  scene.desired = testing::desiredCamera(
      {distance * std::sin(angle), random(1.4, 1.8), distance * std::cos(angle)},
      {random(-0.2, 0.2), random(0.8, 1.3), 0}, width, height);
  for (const glm::dvec3 corner :
       {glm::dvec3(-0.5, 0, 0), {0.5, 0, 0}, {0.5, 2.1, 0}, {-0.5, 2.1, 0}}) {
    scene.region.emplace_back(projectPoint(scene.desired, corner));
  }
  return scene;
}

class WarpBySplat : public ::testing::TestWithParam<Splat> {};

INSTANTIATE_TEST_SUITE_P(Warp, WarpBySplat,
                         ::testing::Values(Splat::k1x1, Splat::k2x2, Splat::k3x3, Splat::kCross,
                                           Splat::kSized, Splat::kNearest, Splat::kMean),
                         [](const auto& test) {
                           return "Splat" + std::string(infoOf(test.param).name);
                         });

TEST_P(WarpBySplat, IsThePlainWarpInEveryPixel) {
  Random random(31);
  std::size_t pixels = 0, differing = 0, cracks = 0, holes = 0;
  for (int i = 0; i < 12; ++i) {
    const Scene scene = randomView(random, 96, 80);
    WarpBuffer buffer;
    buffer.resize(96, 80);
    const WarpCounts counts =
        warpLdi(scene.ldi, scene.desired, scene.region, buffer, {GetParam(), Clip::kTiles});
    const std::vector<bool> region = pixelsIn(scene.region, 96, 80);
    const auto plain = testing::warpPlainly(scene.ldi, scene.desired, region, GetParam());
    for (std::size_t p = 0; p < plain.size(); ++p) {
      const std::uint8_t* rgba = &buffer.color.rgba[4 * p];
      if (!region[p]) {
        continue;
      }
      ++pixels;
      bool same = (rgba[3] != 0) == plain[p].shown;
      for (int c = 0; c < 3; ++c) {
        same = same && (!plain[p].shown || std::abs(rgba[c] - plain[p].color[c]) < 2.0);
      }
      differing += !same;
      cracks += plain[p].shown && !plain[p].covered;
      holes += !plain[p].covered;
    }
    EXPECT_NEAR(static_cast<double>(counts.pixels),
                static_cast<double>(std::count(region.begin(), region.end(), true)), 0.5);
  }
  // Rounding may decide whether a pixel's centre lies at a footprint's very edge, and which of two
  // samples is nearer to it.
  EXPECT_GT(pixels, 10000u);
  EXPECT_LE(differing, pixels / 200);
  EXPECT_GT(holes, 100u);
  if (keepsDepth(GetParam())) {
    EXPECT_GT(cracks, 20u);
  }
}

TEST(Warp, CountsWhatItLeavesUncovered) {
  Random random(32);
  const Scene scene = randomView(random, 160, 128);
  WarpBuffer buffer;
  buffer.resize(160, 128);
  const WarpCounts counts = warpLdi(scene.ldi, scene.desired, scene.region, buffer);
  std::size_t transparent = 0, pixels = 0;
  const std::vector<bool> region = pixelsIn(scene.region, 160, 128);
  for (std::size_t p = 0; p < region.size(); ++p) {
    pixels += region[p];
    transparent += region[p] && buffer.color.rgba[4 * p + 3] == 0;
  }
  EXPECT_EQ(counts.pixels, pixels);
  EXPECT_EQ(counts.pixels_uncovered - counts.pixels_bridged, transparent);
  EXPECT_EQ(counts.samples + counts.samples_clipped, scene.ldi.samples.size());
}

TEST(Warp, WritesEveryPixelInsideTheRegionAndNoneOutside) {
  Random random(33);
  for (int i = 0; i < 20; ++i) {
    Scene scene = randomView(random, 160, 128);
    if (i % 2 == 0) {
      std::reverse(scene.region.begin(), scene.region.end());
    }
    if (i % 4 >= 2) {  // partly beyond the picture, and a triangle
      scene.region = {
          {-30, random(-20.0, 60.0)}, {random(50.0, 220.0), 20}, {80, random(90.0, 200.0)}};
    }
    const std::vector<bool> region = pixelsIn(scene.region, 160, 128);
    WarpBuffer a;
    WarpBuffer b;
    a.resize(160, 128);
    b.resize(160, 128);
    std::fill(a.color.rgba.begin(), a.color.rgba.end(), std::uint8_t{77});
    std::fill(b.color.rgba.begin(), b.color.rgba.end(), std::uint8_t{154});
    warpLdi(scene.ldi, scene.desired, scene.region, a);
    warpLdi(scene.ldi, scene.desired, scene.region, b);
    for (std::size_t p = 0; p < region.size(); ++p) {
      for (std::size_t c = 0; c < 4; ++c) {
        if (region[p]) {
          ASSERT_EQ(a.color.rgba[4 * p + c], b.color.rgba[4 * p + c]);
        } else {
          ASSERT_EQ(a.color.rgba[4 * p + c], 77);
          ASSERT_EQ(b.color.rgba[4 * p + c], 154);
        }
      }
    }
  }
}

TEST_P(WarpBySplat, IsTheSamePictureWithAndWithoutClippingAndForAnyNumberOfThreads) {
  const Splat splat = GetParam();
  Random random(34);
  std::size_t clipped = 0, all = 0;
  for (int i = 0; i < 30; ++i) {
    Scene scene = randomView(random, 320, 256);
    if (i % 3 == 0) {
      scene.ldi = testing::randomLdi(random, i % 2 == 0 ? 60000 : 3000);
    }
    if (i % 5 == 0) {  // an eye anywhere, also among the samples
      scene.desired =
          testing::desiredCamera({random(-2.0, 2.0), random(0.0, 3.0), random(-3.0, 3.0)},
                                 {random(-1.0, 1.0), 1, random(-5.0, 1.0)}, 320, 256);
    }
    WarpBuffer plain;
    plain.resize(320, 256);
    const WarpCounts counts =
        warpLdi(scene.ldi, scene.desired, scene.region, plain, {splat, Clip::kNothing});
    EXPECT_EQ(counts.samples, scene.ldi.samples.size());
    EXPECT_EQ(counts.samples_clipped, 0u);
    for (const int threads : {1, 2, 3, 7}) {
      ThreadTeam team(threads);
      WarpBuffer buffer;
      buffer.resize(320, 256);
      const Clip clip = threads == 3 ? Clip::kColumns : Clip::kTiles;
      const WarpCounts c =
          warpLdi(scene.ldi, scene.desired, scene.region, buffer, {splat, clip, &team});
      ASSERT_EQ(buffer.color.rgba, plain.color.rgba) << i << " on " << threads;
      EXPECT_EQ(c.samples + c.samples_clipped, scene.ldi.samples.size());
      EXPECT_EQ(c.pixels, counts.pixels);
      EXPECT_EQ(c.pixels_uncovered, counts.pixels_uncovered);
      EXPECT_EQ(c.pixels_bridged, counts.pixels_bridged);
      if (threads == 1) {
        clipped += c.samples_clipped;
        all += scene.ldi.samples.size();
      }
    }
  }
  EXPECT_GT(clipped, all / 4);
}

TEST_P(WarpBySplat, NeverAllocatesOnceItHasSeenAWarpAsLarge) {
#ifdef ENFILADE_OTHER_ALLOCATORS
  GTEST_SKIP() << "a sanitizer's allocators do not count";
#endif
  const Splat splat = GetParam();
  Random random(35);
  const Scene scene = randomView(random, 320, 256);
  WarpBuffer buffer;
  buffer.resize(320, 256);
  warpLdi(scene.ldi, scene.desired, scene.region, buffer, {splat, Clip::kTiles});
  const std::size_t before = allocations;
  const WarpCounts counts =
      warpLdi(scene.ldi, scene.desired, scene.region, buffer, {splat, Clip::kTiles});
  EXPECT_EQ(allocations - before, 0u);
  EXPECT_GT(counts.samples, 0u);
}

TEST(Warp, TakesAnEmptyImageAndAnEmptyRegion) {
  Random random(36);
  const Scene scene = randomView(random, 160, 128);
  WarpBuffer buffer;
  buffer.resize(160, 128);
  std::fill(buffer.color.rgba.begin(), buffer.color.rgba.end(), std::uint8_t{9});
  EXPECT_EQ(warpLdi(scene.ldi, scene.desired, {}, buffer).pixels, 0u);
  EXPECT_EQ(buffer.color.rgba, std::vector<std::uint8_t>(buffer.color.rgba.size(), 9));
  const WarpCounts counts = warpLdi(Ldi{}, scene.desired, scene.region, buffer);
  EXPECT_EQ(counts.samples, 0u);
  EXPECT_GT(counts.pixels, 0u);
  EXPECT_EQ(counts.pixels_uncovered, counts.pixels);
}

}  // namespace
}  // namespace enfilade
