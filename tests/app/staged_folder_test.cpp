#include "app/staged_folder.h"

#include <gtest/gtest.h>

#include "scene/error.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

using Names = std::vector<std::string>;
const FolderKind kKind{{"proof"}, {"proof", "more"}};

ErrorKind kindOfFailure(const std::string& folder) {
  try {
    StagedFolder staged(folder, kKind);
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
    StagedFolder staged(here / "report", kKind);
    writeText(staged.path() + "/proof", "new");
    EXPECT_FALSE(std::filesystem::exists(here / "report"));
    EXPECT_EQ(staged.asCommitted(staged.path() + "/proof: no room"),
              here / "report" + "/proof: no room");
    staged.commit();
  }
  EXPECT_EQ(here.names(), Names{"report"});
  EXPECT_EQ(textOf(here / "report/proof"), "new");
}

TEST(StagedFolder, LeavesNothingBehindWhenTheWorkFails) {
  TemporaryFolder here;
  {
    StagedFolder staged(here / "report", kKind);
    writeText(staged.path() + "/proof", "half");
  }
  EXPECT_EQ(here.names(), Names{});
}

TEST(StagedFolder, KeepsTheOldOneWhenTheWorkFailsAndReplacesItWhole) {
  TemporaryFolder here;
  std::filesystem::create_directory(here / "report");
  writeText(here / "report/proof", "old");
  writeText(here / "report/more", "old");
  { StagedFolder failed(here / "report", kKind); }
  EXPECT_EQ(textOf(here / "report/proof"), "old");
  StagedFolder staged(here / "report/", kKind);
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
  StagedFolder(here / "empty", kKind).commit();
  StagedFolder(here / "a/b/c", kKind).commit();
  EXPECT_TRUE(std::filesystem::is_directory(here / "a/b/c"));
}

TEST(StagedFolder, KeepsWhatIsNotItsOwn) {
  TemporaryFolder here;
  std::filesystem::create_directories(here / "report/photos");
  writeText(here / "report/proof", "old");
  writeText(here / "report/more", "old");
  writeText(here / "report/notes", "irreplaceable");
  writeText(here / "report/photos/one", "irreplaceable");
  StagedFolder staged(here / "report", kKind);
  writeText(staged.path() + "/proof", "new");
  staged.commit();
  EXPECT_EQ(here.names(), Names{"report"});
  EXPECT_EQ(textOf(here / "report/proof"), "new");
  EXPECT_EQ(textOf(here / "report/notes"), "irreplaceable");
  EXPECT_EQ(textOf(here / "report/photos/one"), "irreplaceable");
  EXPECT_FALSE(std::filesystem::exists(here / "report/more"));
}

TEST(StagedFolder, DoesNotReplaceWhatHasAppearedMeanwhile) {
  TemporaryFolder here;
  StagedFolder staged(here / "report", kKind);
  writeText(staged.path() + "/proof", "new");
  std::filesystem::create_directory(here / "report");
  writeText(here / "report/notes", "irreplaceable");
  EXPECT_THROW(staged.commit(), Error);
  EXPECT_EQ(textOf(here / "report/notes"), "irreplaceable");
  EXPECT_EQ(textOf(staged.path() + "/proof"), "new");
}

TEST(StagedFolder, RefusesTheFolderThatOneIsInBeforeTheWork) {
  TemporaryFolder here;
  std::filesystem::create_directory(here / "report");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(here / "report");
  EXPECT_EQ(kindOfFailure(here / "report"), ErrorKind::kUsage);
  EXPECT_THROW(StagedFolder(".", kKind), Error);
  std::filesystem::current_path(before);
  EXPECT_THROW(StagedFolder("/proc", FolderKind{{"version"}, {}}), Error);  // a mount point
}

TEST(StagedFolder, ALinkToAFolderStaysOne) {
  TemporaryFolder here;
  std::filesystem::create_directory(here / "real");
  std::filesystem::create_symlink("real", here / "link");
  StagedFolder staged(here / "link", kKind);
  writeText(staged.path() + "/proof", "new");
  staged.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(here / "link"));
  EXPECT_EQ(textOf(here / "real/proof"), "new");
}

TEST(StagedFolder, TakesNothingThatAKilledRunLeft) {
  TemporaryFolder here;
  std::string stale;
  {
    StagedFolder staged(here / "report", kKind);
    stale = staged.path();
  }
  std::filesystem::create_directory(stale);
  writeText(stale + "/stale", "of another run");
  StagedFolder staged(here / "report", kKind);
  writeText(staged.path() + "/proof", "new");
  staged.commit();
  EXPECT_FALSE(std::filesystem::exists(here / "report/stale"));
}

TEST(StagedFolder, SaysThatItCannotBeWritten) {
  EXPECT_EQ(kindOfFailure("/proc/report"), ErrorKind::kMachine);
  TemporaryFolder here;
  writeText(here / "file", "");
  EXPECT_EQ(kindOfFailure(here / "file/report"), ErrorKind::kMachine);
}

}  // namespace
}  // namespace enfilade
