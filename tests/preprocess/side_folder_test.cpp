#include "preprocess/side_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

class SideFolderTest : public ::testing::Test {
 protected:
  SideFolderTest() {
    for (const PortalSide& side : {kFront, kBack}) {
      const SideFolder folder(here_.path(), side);
      writeText(folder.path() + "/ldi.bin", side.from_front ? "front" : "back");
      folder.commit();
    }
  }
  bool counts(const PortalSide& side) const { return bakedFiles(here_.path(), side).has_value(); }
  std::string record(const std::string& side) const { return here_ / ("sides/portal-" + side); }
  std::string image(const std::string& side) const {
    return here_ / ("images/portal-" + side + "/ldi.bin");
  }

  static constexpr PortalSide kFront{3, true}, kBack{3, false};
  TemporaryFolder here_;
};

TEST_F(SideFolderTest, ListsWhatWasBaked) {
  const auto files = bakedFiles(here_.path(), kFront);
  ASSERT_TRUE(files);
  ASSERT_EQ(files->size(), 1u);
  EXPECT_EQ(files->begin()->first, "images/portal-0003-front/ldi.bin");
  EXPECT_TRUE(counts(kBack));
}

TEST_F(SideFolderTest, DoesNotCountWhatIsOfAnotherSide) {
  const auto overwrite = fs::copy_options::overwrite_existing;
  fs::copy_file(image("0003-back"), image("0003-front"), overwrite);
  EXPECT_FALSE(counts(kFront));
  fs::copy_file(record("0003-back"), record("0003-front"), overwrite);
  EXPECT_FALSE(counts(kFront));
  EXPECT_TRUE(counts(kBack));
}

TEST_F(SideFolderTest, DoesNotCountWhatIsNotWhole) {
  const std::string whole = textOf(record("0003-front"));
  for (std::size_t size = 0; size + 1 < whole.size(); ++size) {
    writeText(record("0003-front"), whole.substr(0, size));
    EXPECT_FALSE(counts(kFront)) << size;
  }
  for (const char* text : {"end\n", "portal-0003-front\nend\n"}) {
    writeText(record("0003-front"), text);
    EXPECT_FALSE(counts(kFront)) << text;
  }
  writeText(record("0003-front"), whole);
  EXPECT_TRUE(counts(kFront));
}

}  // namespace
}  // namespace enfilade
