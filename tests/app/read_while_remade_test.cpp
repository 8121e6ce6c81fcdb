// A house that is made anew while somebody reads it: what is read is the old one or the new one,
// whole, or a line says that it cannot be read.
#include <gtest/gtest.h>

#include <atomic>
#include <map>
#include <thread>

#include "portals/house.h"
#include "scene/error.h"
#include "tests/app/resume_model.h"

namespace enfilade {
namespace {

using Files = std::map<std::string, std::vector<std::uint8_t>>;

Files readFiles(const std::string& folder) {
  const House house = readHouse(folder);
  Files files;
  for (const auto& [name, checksum] : house.files) files[name] = readHouseFile(house, folder, name);
  return files;
}

class ReadWhileRemade : public ::testing::Test {
 protected:
  ProgramResult make(const std::string& model, const std::string& house) const {
    return runEnfilade({"preprocess", model, "-o", house, "--image-size", "32", "--captures",
                        "ring:3", "--sight-lines", "2000", "--quiet"},
                       here_.path());
  }

  TemporaryFolder here_;
};

TEST_F(ReadWhileRemade, ItIsTheOldOneOrTheNewOneOrNone) {
  constexpr int kTimes = 12;
  TestBuilding other;
  other.building = roomRow();
  other.box({1, 0, 1}, {2, 1, 2});
  writeGlb(here_ / "old.glb", roomRow());
  writeGlb(here_ / "new.glb", other.building);
  ASSERT_EQ(make("old.glb", "old").status, 0);
  ASSERT_EQ(make("new.glb", "new").status, 0);
  ASSERT_EQ(make("old.glb", "house").status, 0);
  const Files old_files = readFiles(here_ / "old"), new_files = readFiles(here_ / "new");
  ASSERT_NE(old_files, new_files);

  std::atomic<bool> done{false};
  std::thread maker([&] {
    for (int i = 0; i < kTimes; ++i) {
      const ProgramResult result = make(i % 2 == 0 ? "new.glb" : "old.glb", "house");
      EXPECT_EQ(result.status, 0) << result.errors;
    }
    done = true;
  });
  int old_ones = 0, new_ones = 0;
  while (!done) {
    try {
      const Files files = readFiles(here_ / "house");
      const bool is_old = files == old_files;
      EXPECT_TRUE(is_old || files == new_files) << "a house of both";
      ++(is_old ? old_ones : new_ones);
    } catch (const Error& refused) {
      const std::string line = refused.what();
      EXPECT_NE(line.find("/house"), std::string::npos) << line;
      EXPECT_EQ(line.find('\n'), std::string::npos) << line;
    }
  }
  maker.join();
  EXPECT_GT(old_ones, 0);
  EXPECT_GT(new_ones, 0);
  EXPECT_EQ(readFiles(here_ / "house"), old_files);
}

}  // namespace
}  // namespace enfilade
