#include "app/frame_files.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

TEST(FrameFiles, OfALongerWalkGoAndNothingElse) {
  const TemporaryFolder here;
  for (const char* folder : {"ldi", "warp"}) std::filesystem::create_directory(here / folder);
  const auto lay = [&](const std::string& file) { writeText(here / file, ""); };
  for (std::size_t frame = 0; frame < 5; ++frame) {
    lay(frameFile(Method::kLdi, frame));
    lay(frameFile(Method::kWarp, frame));
  }
  lay("ldi/notes.txt");
  removeFramesFrom(2, here.path(), Method::kLdi);
  std::size_t left = 0;
  for (std::size_t frame = 0; frame < 5; ++frame) {
    const bool is_there = std::filesystem::exists(here / frameFile(Method::kLdi, frame));
    EXPECT_EQ(is_there, frame < 2);
    left += std::filesystem::exists(here / frameFile(Method::kWarp, frame));
  }
  EXPECT_EQ(left, 5u);
  EXPECT_TRUE(std::filesystem::exists(here / "ldi/notes.txt"));
}

}  // namespace
}  // namespace enfilade
