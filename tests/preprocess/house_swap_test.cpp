#include "preprocess/house_swap.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <map>

#include "scene/error.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

using Files = std::map<std::string, std::string>;

const Files kOld = {{"house.json", "old"},
                    {"geometry.glb", "old"},
                    {"cells.grid", "old"},
                    {"images/portal-0000-front/ldi.bin", "old"},
                    {"images/portal-0007-back/ldi.bin", "old"}};
const Files kNew = {{"house.json", "new"},
                    {"geometry.glb", "new"},
                    {"cells.grid", "new"},
                    {"images/portal-0000-front/ldi.bin", "new"}};

/// An older house, and a finished one in its folder `unfinished`.
class HouseSwap : public ::testing::Test {
 protected:
  HouseSwap() { layOut(); }

  void layOut() {
    fs::remove_all(house_);
    fs::create_directories(unfinished_);
    for (const auto& [name, text] : kOld) put(house_, name, text);
    for (const auto& [name, text] : kNew) {
      put(unfinished_, name == "house.json" ? "finished.json" : name, text);
    }
  }

  static void put(const std::string& folder, const std::string& name, const std::string& text) {
    const fs::path file = fs::path(folder) / name;
    fs::create_directories(file.parent_path());
    writeText(file.string(), text);
  }

  /// What is in the house but for what is unfinished.
  Files files() const {
    Files files;
    for (const auto& entry : fs::recursive_directory_iterator(house_)) {
      const std::string name = fs::relative(entry.path(), house_).string();
      if (entry.is_regular_file() && !name.starts_with("unfinished/")) {
        files[name] = textOf(entry.path().string());
      }
    }
    return files;
  }

  /// As it is after the first `count` of the eight steps of which the change is made.
  void stopAfter(std::size_t count) {
    layOut();
    const std::string replaced = replacedFolder(unfinished_);
    const std::array<std::array<std::string, 2>, 8> steps = {
        {{house_ + "/house.json", replaced + "/house.json"},
         {house_ + "/images", replaced + "/images"},
         {house_ + "/geometry.glb", replaced + "/geometry.glb"},
         {house_ + "/cells.grid", replaced + "/cells.grid"},
         {unfinished_ + "/cells.grid", house_ + "/cells.grid"},
         {unfinished_ + "/geometry.glb", house_ + "/geometry.glb"},
         {unfinished_ + "/images", house_ + "/images"},
         {unfinished_ + "/finished.json", house_ + "/house.json"}}};
    fs::create_directories(replaced);
    for (std::size_t i = 0; i < count; ++i) fs::rename(steps[i][0], steps[i][1]);
  }

  TemporaryFolder here_;
  std::string house_ = here_ / "house";
  std::string unfinished_ = here_ / "house/unfinished";
};

TEST_F(HouseSwap, GoesOnFromEachOfItsSteps) {
  for (std::size_t steps = 0; steps <= 8; ++steps) {
    SCOPED_TRACE(steps);
    stopAfter(steps);
    swapHouse(house_, unfinished_);
    EXPECT_EQ(files(), kNew);
  }
}

TEST_F(HouseSwap, CanBeTakenBackUntilTheFirstNewPartIsThere) {
  for (std::size_t steps = 0; steps <= 4; ++steps) {
    SCOPED_TRACE(steps);
    stopAfter(steps);
    unswapHouse(house_, unfinished_);
    EXPECT_EQ(files(), kOld);
  }
  stopAfter(5);
  unswapHouse(house_, unfinished_);
  EXPECT_EQ(files(), (Files{{"cells.grid", "new"}}));
}

TEST_F(HouseSwap, LeavesTheOlderHouseWholeIfAPartOfItCannotBeMoved) {
  put(replacedFolder(unfinished_), "images/in the way", "");
  try {
    swapHouse(house_, unfinished_);
    FAIL() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kMachine);
    EXPECT_EQ(error.what(), house_ + "/images: cannot be replaced: Directory not empty");
  }
  EXPECT_EQ(files(), kOld);
  fs::remove_all(replacedFolder(unfinished_));
  swapHouse(house_, unfinished_);
  EXPECT_EQ(files(), kNew);
}

TEST_F(HouseSwap, MovesALinkNotWhatItLeadsTo) {
  fs::rename(house_ + "/images", here_ / "elsewhere");
  fs::create_directory_symlink(here_ / "elsewhere", house_ + "/images");
  swapHouse(house_, unfinished_);
  EXPECT_EQ(files(), kNew);
  EXPECT_FALSE(fs::is_symlink(house_ + "/images"));
  EXPECT_TRUE(fs::exists(here_ / "elsewhere/portal-0007-back/ldi.bin"));
}

TEST_F(HouseSwap, AHouseWithoutImagesHasNoFolderForThem) {
  fs::remove_all(unfinished_ + "/images/portal-0000-front");
  swapHouse(house_, unfinished_);
  EXPECT_FALSE(fs::exists(house_ + "/images"));
}

}  // namespace
}  // namespace enfilade
