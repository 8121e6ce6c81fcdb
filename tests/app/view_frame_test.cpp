// How the window chooses what to paint and says what it cost.
#include <gtest/gtest.h>

#include <cmath>

#include "app/view/frame_history.h"
#include "app/view/layer_colors.h"
#include "app/view/resolution.h"
#include "ibr/ldi_packing.h"

namespace enfilade {
namespace {

TEST(FrameHistory, StagesAddUpToTheFrame) {
  FrameCost cost;
  cost.frametime_ms = 10;
  cost.cull_ms = 1;
  cost.warp_ms = 2;
  cost.draw_ms = 4;
  double sum = 0;
  for (const double stage : stagesOf(cost)) sum += stage;
  EXPECT_DOUBLE_EQ(sum, 10);
  EXPECT_DOUBLE_EQ(stagesOf(cost).back(), 3);
}

TEST(FrameHistory, KeepsTheFramesOfLateAndNoMore) {
  FrameHistory history;
  EXPECT_EQ(history.medianMs(15), 0);
  for (std::size_t i = 0; i < FrameHistory::kLength + 10; ++i) {
    FrameCost cost;
    cost.frametime_ms = static_cast<double>(i);
    history.add(cost);
  }
  EXPECT_EQ(history.costs().size(), FrameHistory::kLength);
  EXPECT_EQ(history.last().frametime_ms, FrameHistory::kLength + 9.0);
  EXPECT_EQ(history.medianMs(3), FrameHistory::kLength + 8.0);
}

/// Moves through frames that take `ms` at full size, as long as their pixels say.
glm::ivec2 sizeAfterMoving(Resolution& resolution, double ms, int frames) {
  const glm::ivec2 window(1000, 800);
  for (int i = 0; i < frames; ++i) {
    const glm::dvec2 share = glm::dvec2(resolution.sizeFor(window, true)) / glm::dvec2(window);
    resolution.note(ms * share.x * share.y);
  }
  return resolution.sizeFor(window, true);
}

TEST(Resolution, FastFramesHaveEveryPixel) {
  Resolution resolution;
  EXPECT_EQ(sizeAfterMoving(resolution, 20, 50), glm::ivec2(1000, 800));
  EXPECT_FALSE(resolution.reduced());
}

TEST(Resolution, SlowFramesGetCoarserUntilTheyAnswerAtOnceAndFinerAgain) {
  Resolution resolution;
  const glm::ivec2 coarse = sizeAfterMoving(resolution, 120, 50);
  EXPECT_LT(coarse.x, 700);
  EXPECT_LT(120.0 * coarse.x * coarse.y / (1000.0 * 800.0), 45);
  EXPECT_EQ(sizeAfterMoving(resolution, 10, 50), glm::ivec2(1000, 800));
}

TEST(Resolution, DoesNotSwayBetweenTwoSizes) {
  for (double ms = 20; ms < 400; ms += 7) {
    Resolution resolution;
    const glm::ivec2 settled = sizeAfterMoving(resolution, ms, 30);
    for (int i = 0; i < 10; ++i) EXPECT_EQ(sizeAfterMoving(resolution, ms, 1), settled) << ms;
  }
}

TEST(Resolution, StandingStillShowsEveryPixelAndSoDoesWhoAsksForIt) {
  Resolution resolution;
  sizeAfterMoving(resolution, 300, 50);
  EXPECT_EQ(resolution.sizeFor({1000, 800}, false), glm::ivec2(1000, 800));
  resolution.setFixed(true);
  EXPECT_EQ(resolution.sizeFor({1000, 800}, true), glm::ivec2(1000, 800));
}

/// One tile with three samples in pixel (2, 3), white, and one in pixel (5, 5), black.
Ldi smallLdi() {
  Ldi ldi;
  ldi.tiles.push_back({0, 0, 0, 4});
  for (const float disparity : {0.1f, 0.3f, 0.6f}) {
    ldi.samples.push_back({255, 255, 255, 0x44, packPlace(2.5f, 3.5f, disparity)});
  }
  ldi.samples.push_back({0, 0, 0, 0x44, packPlace(5.5f, 5.5f, 0.8f)});
  return ldi;
}

TEST(LayerColors, TheNearestOfAPixelIsGreenAndThoseBehindTurnRed) {
  const Ldi colored = coloredByLayer(smallLdi());
  const auto& third = colored.samples[0];
  const auto& second = colored.samples[1];
  const auto& first = colored.samples[2];
  EXPECT_GT(first.g, first.r);
  EXPECT_GT(second.g, 200);
  EXPECT_GT(second.r, 200);
  EXPECT_GT(third.r, third.g);
  EXPECT_GT(colored.samples[3].g, colored.samples[3].r) << "the only one of its pixel";
  EXPECT_LT(colored.samples[3].g, first.g) << "as dark as it was";
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(colored.samples[i].place, smallLdi().samples[i].place);
  }
}

TEST(LayerColors, AnImageThatGrewIsColoredAnew) {
  Ldi ldi = smallLdi();
  LayerColors colors;
  EXPECT_EQ(colors.of(ldi)->samples.size(), 4u);
  ldi.samples.push_back({9, 9, 9, 0x44, packPlace(7.5f, 5.5f, 0.9f)});
  ldi.tiles[0].count = 5;
  EXPECT_EQ(colors.of(ldi)->samples.size(), 5u);
}

}  // namespace
}  // namespace enfilade
