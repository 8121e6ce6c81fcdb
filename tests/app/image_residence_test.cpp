// Which images are in memory in which frame, when not all may be.
#include "app/image_residence.h"

#include <gtest/gtest.h>

#include <random>

namespace enfilade {
namespace {

constexpr std::size_t kMegabyte = std::size_t{1} << 20;

/// Plays `frames` frames that want `sides`.
void play(ImageResidence& residence, const std::vector<std::size_t>& sides, int frames) {
  for (int i = 0; i < frames; ++i) {
    residence.beginFrame();
    residence.endFrame(sides);
  }
}

TEST(ImageResidence, ASideIsThereSomeFramesAfterItWasAskedForTheLongerTheLargerItIs) {
  const auto framesUntilThere = [](std::size_t bytes) {
    ImageResidence residence({bytes}, 100 * kMegabyte);
    play(residence, {}, 1);
    int frames = 0;
    for (; !residence.isThere(0); ++frames) play(residence, {0}, 1);
    return frames;
  };
  EXPECT_EQ(framesUntilThere(100), 2) << "asked for at the end of one, there in the next";
  EXPECT_GT(framesUntilThere(9 * kMegabyte), framesUntilThere(3 * kMegabyte));
}

TEST(ImageResidence, WhatTheFirstFrameWantsIsThereInTheSecond) {
  ImageResidence residence(std::vector<std::size_t>(30, 9 * kMegabyte), 1000 * kMegabyte);
  std::vector<std::size_t> sides;
  for (std::size_t side = 0; side < 30; ++side) sides.push_back(side);
  play(residence, sides, 1);
  EXPECT_EQ(residence.beginFrame().size(), 30u);
}

TEST(ImageResidence, WhatArrivesIsToldOnceInTheFrameInWhichItIsThere) {
  ImageResidence residence({kMegabyte, kMegabyte, 0}, 100 * kMegabyte);
  std::vector<std::size_t> arrived;
  for (int i = 0; i < 20; ++i) {
    for (const std::size_t side : residence.beginFrame()) {
      EXPECT_TRUE(residence.isThere(side));
      arrived.push_back(side);
    }
    residence.endFrame(std::vector<std::size_t>{1, 0, 2});
  }
  EXPECT_EQ(arrived, (std::vector<std::size_t>{1, 0})) << "the most urgent first";
  EXPECT_FALSE(residence.isThere(2)) << "it has no images";
}

TEST(ImageResidence, TheSideWantedTheLongestAgoGivesWay) {
  ImageResidence residence({4, 4, 4, 4}, 12);
  for (const std::size_t side : {0u, 1u, 2u}) play(residence, {side}, 5);
  play(residence, {0}, 1);  // again: 1 is the oldest now
  play(residence, {3}, 5);
  EXPECT_TRUE(residence.isThere(0));
  EXPECT_FALSE(residence.keeps(1));
  EXPECT_TRUE(residence.isThere(2));
  EXPECT_TRUE(residence.isThere(3));
}

TEST(ImageResidence, WhatDoesNotFitBesideMoreUrgentSidesIsLeftOutAndDisplacesNothing) {
  ImageResidence residence({6, 6, 3}, 10);
  play(residence, {0, 1, 2}, 10);
  EXPECT_TRUE(residence.isThere(0));
  EXPECT_FALSE(residence.keeps(1));
  EXPECT_TRUE(residence.isThere(2)) << "smaller, so there is room";
  EXPECT_TRUE(residence.satisfied());
}

TEST(ImageResidence, ASideLargerThanTheLimitNeverComes) {
  ImageResidence residence({11, 4}, 10);
  play(residence, {0, 1}, 50);
  EXPECT_FALSE(residence.keeps(0));
  EXPECT_TRUE(residence.isThere(1));
  ImageResidence nothing({1, 1}, 0);
  play(nothing, {0, 1}, 50);
  EXPECT_EQ(nothing.bytes(), 0u);
}

TEST(ImageResidence, ALowerLimitIsKeptFromTheNextFrameOn) {
  ImageResidence residence({4, 4, 4}, 12);
  play(residence, {0, 1, 2}, 10);
  EXPECT_EQ(residence.bytes(), 12u);
  residence.setLimit(8);
  play(residence, {2, 0, 1}, 1);
  EXPECT_EQ(residence.bytes(), 8u);
  EXPECT_FALSE(residence.keeps(1));
}

TEST(ImageResidence, RandomWalksNeverKeepMoreThanTheLimitNorLoseWhatFitsAndIsWanted) {
  std::mt19937 random(7);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int walk = 0; walk < 50; ++walk) {
    std::vector<std::size_t> bytes(20);
    for (std::size_t& b : bytes) b = below(5) == 0 ? 0 : 1 + below(3 * kMegabyte);
    const std::size_t most = below(20 * kMegabyte);
    ImageResidence residence(bytes, most);
    std::vector<bool> there_before(bytes.size());
    for (int frame = 0; frame < 200; ++frame) {
      residence.beginFrame();
      std::vector<std::size_t> sides(bytes.size());
      for (std::size_t i = 0; i < sides.size(); ++i) sides[i] = i;
      std::shuffle(sides.begin(), sides.end(), random);
      sides.resize(below(8));
      residence.endFrame(sides);
      ASSERT_LE(residence.bytes(), most);
      std::size_t kept = 0, room = most;
      for (std::size_t i = 0; i < bytes.size(); ++i) kept += residence.keeps(i) ? bytes[i] : 0;
      ASSERT_EQ(kept, residence.bytes());
      for (const std::size_t side : sides) {
        if (bytes[side] == 0 || bytes[side] > room) continue;
        room -= bytes[side];
        ASSERT_TRUE(residence.isThere(side) || !there_before[side]) << "wanted, yet it went";
      }
      for (std::size_t i = 0; i < bytes.size(); ++i) there_before[i] = residence.isThere(i);
    }
  }
}

}  // namespace
}  // namespace enfilade
