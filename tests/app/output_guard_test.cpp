#include "app/output_guard.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "scene/error.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

bool isRefused(const std::string& output, const std::string& input) {
  try {
    refuseToReplace(output, input);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    return true;
  }
  return false;
}

TEST(OutputGuard, RefusesTheInputAndWhatIsReadOfAFolder) {
  TemporaryFolder here;
  std::filesystem::create_directories(here / "house/images/portal-0000-front");
  writeText(here / "house/house.json", "");
  writeText(here / "plan.json", "");
  std::filesystem::create_directory_symlink("house", here / "link");
  EXPECT_TRUE(isRefused(here / "plan.json", here / "plan.json"));
  EXPECT_TRUE(isRefused(here / "house/house.json", here / "house"));
  EXPECT_TRUE(isRefused(here / "house/geometry.glb", here / "house/"));
  EXPECT_TRUE(isRefused(here / "link/cells.grid", here / "house"));
  EXPECT_TRUE(isRefused(here / "house/images/portal-0000-front", here / "link"));
  EXPECT_TRUE(isRefused(here / "house/x/../frames.csv", here / "house"));
  EXPECT_TRUE(isRefused(here / "house/report.html", here / "house"));
}

TEST(OutputGuard, AllowsWhatIsNotRead) {
  TemporaryFolder here;
  std::filesystem::create_directory(here / "house");
  writeText(here / "plan.json", "");
  EXPECT_FALSE(isRefused("", here / "house"));
  EXPECT_FALSE(isRefused(here / "house/plan.svg", here / "house"));
  EXPECT_FALSE(isRefused(here / "house.json", here / "house"));
  EXPECT_FALSE(isRefused(here / "plan.glb", here / "plan.json"));
  EXPECT_FALSE(isRefused(here / "gallery.glb", "gallery"));
}

}  // namespace
}  // namespace enfilade
