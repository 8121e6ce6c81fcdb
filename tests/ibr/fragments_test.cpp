#include "ibr/fragments.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "random_cameras.h"

namespace enfilade {
namespace {

using testing::Random;

constexpr int kWidth = 120, kHeight = 90;

std::vector<TileWeight> randomTiles(Random& random, int count) {
  std::vector<TileWeight> tiles;
  for (int i = 0; i < count; ++i) {
    tiles.push_back({glm::vec2(random(0.0, 1.0 * kWidth), random(0.0, 1.0 * kHeight)),
                     static_cast<float>(random(1.0, 400.0))});
  }
  return tiles;
}

/// Epipoles within the picture, beside it, behind the eye, and at infinity.
glm::dvec3 randomEpipole(Random& random) {
  const glm::dvec2 at(random(-2.0 * kWidth, 3.0 * kWidth), random(-2.0 * kHeight, 3.0 * kHeight));
  switch (random(0, 4)) {
    case 0:
      return glm::dvec3(random(0.0, 1.0 * kWidth), random(0.0, 1.0 * kHeight), 1);
    case 1:
      return -0.3 * glm::dvec3(at, 1.0);
    case 2:
      return glm::dvec3(at, 0.0);
    default:
      return 1e6 * glm::dvec3(at, 1.0);
  }
}

TEST(Fragments, EveryPixelIsInOneOfThem) {
  Random random(51);
  std::array<Fragment, kMostFragments> fragments;
  for (int i = 0; i < 200; ++i) {
    std::vector<TileWeight> tiles = randomTiles(random, random(1, 300));
    const std::size_t count =
        cutIntoFragments(randomEpipole(random), tiles, random(1, 20), fragments);
    for (int y = 0; y < kHeight; ++y) {
      const glm::ivec2 span(random(0, 40), random(41, kWidth + 1));
      std::vector<int> owners(kWidth, 0);
      for (std::size_t f = 0; f < count; ++f) {
        const glm::ivec2 columns = fragments[f].columns(y, span);
        for (int x = columns.x; x < columns.y; ++x) ++owners[static_cast<std::size_t>(x)];
      }
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_EQ(owners[static_cast<std::size_t>(x)], x >= span.x && x < span.y ? 1 : 0);
      }
    }
  }
}

TEST(Fragments, AreTouchedByEveryBoxThatHasAPixelInOrBesideThem) {
  Random random(52);
  std::array<Fragment, kMostFragments> fragments;
  int apart = 0;
  for (int i = 0; i < 300; ++i) {
    std::vector<TileWeight> tiles = randomTiles(random, 100);
    const std::size_t count = cutIntoFragments(randomEpipole(random), tiles, 5, fragments);
    const glm::ivec2 low(random(0, kWidth - 20), random(0, kHeight - 20));
    const glm::ivec2 high = low + glm::ivec2(random(1, 20), random(1, 20));
    const glm::vec2 first = glm::vec2(low) + 0.5f;
    const glm::vec2 last = glm::vec2(high) - 0.5f;
    const ScreenBox box{first.x, first.y, last.x, last.y};
    for (std::size_t f = 0; f < count; ++f) {
      bool touches = false;
      for (int y = low.y - 1; y < high.y + 1; ++y) {
        const glm::ivec2 columns = fragments[f].columns(y, {low.x - 1, high.x + 1});
        touches = touches || columns.x < columns.y;
      }
      ASSERT_TRUE(!touches || fragments[f].mayTouch(box));
      apart += !fragments[f].mayTouch(box);
    }
  }
  EXPECT_GT(apart, 500);
}

TEST(Fragments, HaveAboutAsManySamplesEach) {
  Random random(53);
  std::array<Fragment, kMostFragments> fragments;
  for (int i = 0; i < 100; ++i) {
    const std::vector<TileWeight> tiles = randomTiles(random, 600);
    const int wanted = random(2, 9);
    std::vector<TileWeight> work = tiles;
    const std::size_t count = cutIntoFragments(randomEpipole(random), work, wanted, fragments);
    ASSERT_EQ(count, static_cast<std::size_t>(wanted));
    double all = 0;
    std::vector<double> weights(count, 0.0);
    for (const TileWeight& t : tiles) {
      const int x = static_cast<int>(t.at.x);
      const int y = static_cast<int>(t.at.y);
      for (std::size_t f = 0; f < count; ++f) {
        const glm::ivec2 columns = fragments[f].columns(y, {x, x + 1});
        weights[f] += columns.x < columns.y ? static_cast<double>(t.weight) : 0.0;
      }
      all += static_cast<double>(t.weight);
    }
    EXPECT_LT(*std::max_element(weights.begin(), weights.end()), 1.6 * all / wanted);
  }
}

TEST(Fragments, AreCutAlongLinesThroughTheEpipole) {
  Random random(54);
  std::array<Fragment, kMostFragments> fragments;
  for (int i = 0; i < 100; ++i) {
    std::vector<TileWeight> tiles = randomTiles(random, 300);
    const glm::dvec3 epipole = randomEpipole(random);
    const std::size_t count = cutIntoFragments(epipole, tiles, 6, fragments);
    for (std::size_t f = 0; f < count; ++f) {
      for (std::size_t k = 0; k < fragments[f].count; ++k) {
        const CutLine& line = fragments[f].lines[k];
        const double off = glm::dot(glm::dvec3(line.a, line.b, line.c), epipole);
        EXPECT_NEAR(off / glm::length(epipole), 0.0, 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace enfilade
