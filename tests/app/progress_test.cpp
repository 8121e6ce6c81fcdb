#include "app/progress.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

TEST(Progress, TheBarFillsFromEmptyToFullAndNoFurther) {
  EXPECT_EQ(progressBar(0, 8), "[--------]");
  EXPECT_EQ(progressBar(0.5, 8), "[####----]");
  EXPECT_EQ(progressBar(1, 8), "[########]");
  EXPECT_EQ(progressBar(7, 8), "[########]");
  EXPECT_EQ(progressBar(-1, 8), "[--------]");
}

TEST(Progress, AFinishedStageSaysItsTimeAndNoShare) {
  EXPECT_EQ(progressLine("voxelise", 1, 2.04), "voxelise                                2.0 s");
  EXPECT_EQ(progressLine("voxelise", 0.25, 2.04), "voxelise                      25 %      2.0 s");
}

TEST(Progress, AStageUnderWaySaysWhatRemains) {
  EXPECT_EQ(progressLine("bake", 0.44, 12.1, "37 of 84, 15 s left"),
            "bake                          44 %     12.1 s  37 of 84, 15 s left");
  EXPECT_EQ(remainingText(37 / 84.0, 84, 15.4), "37 of 84, 15 s left");
  EXPECT_EQ(remainingText(0, 84, -1), "0 of 84");
  EXPECT_EQ(remainingText(0.5, 0, 95), "95 s left");
  EXPECT_EQ(remainingText(0.5, 0, 1800), "30 min left");
  EXPECT_EQ(remainingText(0.5, 0, -1), "");
}

TEST(Progress, WithoutATerminalAStageIsOneLineWhenItEnds) {
  testing::internal::CaptureStderr();
  {
    ProgressPrinter printer(false);
    const ProgressSink sink = printer.sink();
    for (int i = 0; i <= 100; ++i) sink("one", i / 100.0);
    sink("one", 1);  // said twice
    sink("two", 0);
    sink("three", 0);  // "two" ends where another begins
    sink("three", 0.5);
  }
  const std::string text = testing::internal::GetCapturedStderr();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 2) << text;
  EXPECT_EQ(text.find('\r'), std::string::npos);
  EXPECT_EQ(text.find("three"), std::string::npos) << "a stage that did not end is not reported";
}

TEST(Progress, QuietSaysNothing) {
  testing::internal::CaptureStderr();
  {
    ProgressPrinter printer(true);
    printer.update("one", 0);
    printer.update("one", 1);
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace enfilade
