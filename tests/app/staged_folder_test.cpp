#include "app/staged_folder.h"

#include <gtest/gtest.h>

#include "scene/error.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

using Names = std::vector<std::string>;

ErrorKind kindOfFailure(const std::string& folder) {
  try {
    StagedFolder staged(folder, "proof");
  } catch (const Error& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with(folder)) << error.what();
    return error.kind();
  }
  ADD_FAILURE() << folder << " was taken";
  return ErrorKind::kMachine;
}

TEST(StagedFolder, IsNotThereUntilItIsComplete) {
  TemporaryFolder here;
  {
    StagedFolder staged(here / "report", "proof");
    writeText(staged.path() + "/proof", "new");
    EXPECT_FALSE(std::filesystem::exists(here / "report"));
    staged.commit();
  }
  EXPECT_EQ(here.names(), Names{"report"});
  EXPECT_EQ(textOf(here / "report/proof"), "new");
}

TEST(StagedFolder, LeavesNothingBehindWhenTheWorkFails) {
  TemporaryFolder here;
  {
    StagedFolder staged(here / "report", "proof");
    writeText(staged.path() + "/proof", "half");
  }
  EXPECT_EQ(here.names(), Names{});
}

TEST(StagedFolder, KeepsTheOldOneWhenTheWorkFailsAndReplacesItWhole) {
  TemporaryFolder here;
  std::filesystem::create_directory(here / "report");
  writeText(here / "report/proof", "old");
  writeText(here / "report/more", "old");
  { StagedFolder failed(here / "report", "proof"); }
  EXPECT_EQ(textOf(here / "report/proof"), "old");
  StagedFolder staged(here / "report/", "proof");
  writeText(staged.path() + "/proof", "new");
  staged.commit();
  EXPECT_EQ(here.names(), Names{"report"});
  EXPECT_EQ(textOf(here / "report/proof"), "new");
  EXPECT_FALSE(std::filesystem::exists(here / "report/more"));
}

TEST(StagedFolder, RefusesAFolderThatHoldsSomethingElse) {
  TemporaryFolder here;
  std::filesystem::create_directory(here / "thesis");
  writeText(here / "thesis/chapter", "irreplaceable");
  EXPECT_EQ(kindOfFailure(here / "thesis"), ErrorKind::kUsage);
  EXPECT_EQ(kindOfFailure(here / "thesis/chapter"), ErrorKind::kUsage);
  EXPECT_EQ(textOf(here / "thesis/chapter"), "irreplaceable");
  EXPECT_EQ(here.names(), Names{"thesis"});
}

TEST(StagedFolder, TakesAnEmptyFolderAndMakesMissingParents) {
  TemporaryFolder here;
  std::filesystem::create_directory(here / "empty");
  StagedFolder(here / "empty", "proof").commit();
  StagedFolder(here / "a/b/c", "proof").commit();
  EXPECT_TRUE(std::filesystem::is_directory(here / "a/b/c"));
}

TEST(StagedFolder, SaysThatItCannotBeWritten) {
  EXPECT_EQ(kindOfFailure("/proc/report"), ErrorKind::kMachine);
  TemporaryFolder here;
  writeText(here / "file", "");
  EXPECT_EQ(kindOfFailure(here / "file/report"), ErrorKind::kMachine);
}

}  // namespace
}  // namespace enfilade
