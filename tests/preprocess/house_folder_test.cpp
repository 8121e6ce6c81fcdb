#include "preprocess/house_folder.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "scene/error.h"
#include "tests/app/temporary_folder.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

std::string refusalOf(const std::string& folder) {
  try {
    const HouseFolder house(folder);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    return error.what();
  }
  return {};
}

class HouseFolderTest : public ::testing::Test {
 protected:
  HouseFolderTest() { fs::create_directory(here_ / "house"); }
  void put(const std::string& name, const std::string& text = "irreplaceable") {
    fs::create_directories(fs::path(here_ / ("house/" + name)).parent_path());
    writeText(here_ / ("house/" + name), text);
  }
  void putHouse() { put("house.json", R"({"enfilade": "house"})"); }
  TemporaryFolder here_;
};

TEST_F(HouseFolderTest, TakesAHouseAndWhatIsUnfinished) {
  EXPECT_EQ(refusalOf(here_ / "house"), "");
  put("unfinished/job.json", R"({"program": "enfilade"})");
  put("unfinished/sides/portal-0000-front");
  put("unfinished/images/portal-0003-back.part/ldi.bin.tmp-12");
  put("geometry.glb");  // moved already
  EXPECT_EQ(refusalOf(here_ / "house"), "");
  putHouse();
  put("images/portal-0012-front/ldi.bin");
  put("images/portal-12345-back/ldi.bin");
  put("images/portal-12345-back/texture-00.png");
  put("images/portal-12345-back/reference-117.bin");
  put("house.json.tmp-123");
  EXPECT_EQ(refusalOf(here_ / "house"), "");
}

TEST_F(HouseFolderTest, TakesWhatARunLeftThatWasStoppedAtOnce) {
  fs::create_directories(here_ / "house/unfinished");
  EXPECT_EQ(refusalOf(here_ / "house"), "");
  put("unfinished/job.json.tmp-123");
  EXPECT_EQ(refusalOf(here_ / "house"), "");
  put("unfinished/job.json", "");  // by a power cut
  EXPECT_EQ(refusalOf(here_ / "house"), "");
}

TEST_F(HouseFolderTest, RefusesWhatOnlyBearsTheNamesOfAHouse) {
  put("images/photo.jpg");
  EXPECT_NE(refusalOf(here_ / "house").find("holds other things (images)"), std::string::npos);
  putHouse();
  EXPECT_NE(refusalOf(here_ / "house").find("(images/photo.jpg)"), std::string::npos);
  for (const char* name : {"geometry.glb", "house.json", "unfinished", "unfinished/job.json",
                           "unfinished/geometry.glb", "unfinished/house.json"}) {
    fs::remove_all(here_ / "house");
    put(name);
    EXPECT_NE(refusalOf(here_ / "house").find("holds other things ("), std::string::npos) << name;
  }
}

TEST_F(HouseFolderTest, RefusesWhatIsOfNoHouseHoweverDeepItLies) {
  for (const std::string name :
       {"images/portal-0000-front/photo.jpg", "images/portal-0000-front/ldi.bin/x",
        "images/portal-0009-front", "unfinished/notes.txt", "unfinished/sides/precious",
        "unfinished/images/portal-0000-front/texture-0a.png", "unfinished/replaced/notes.txt",
        "geometry.glb/x"}) {
    fs::remove_all(here_ / "house");
    putHouse();
    put(name);
    EXPECT_NE(refusalOf(here_ / "house").find("holds other things ("), std::string::npos) << name;
  }
}

TEST_F(HouseFolderTest, RefusesWhatIsNoFileOfItsOwnHalfWritten) {
  putHouse();
  for (const char* name : {"notes.tmp-7", "house.json.tmp-backup", "geometry.glb.tmp-1/x"}) {
    put(name);
    EXPECT_NE(refusalOf(here_ / "house"), "") << name;
    fs::remove_all(here_ / "house");
    putHouse();
  }
}

TEST_F(HouseFolderTest, RefusesAnEmptyName) { EXPECT_NE(refusalOf(""), ""); }

TEST_F(HouseFolderTest, MakesWhatIsMeantBehindALink) {
  fs::create_directories(here_ / "far/away");
  fs::create_directory_symlink("far/away", here_ / "link");
  const HouseFolder beside(here_ / "link/../made");
  EXPECT_TRUE(fs::is_directory(here_ / "far/made"));
  EXPECT_FALSE(fs::exists(here_ / "made"));
  const HouseFolder deep(here_ / "none/../deep");
  EXPECT_TRUE(fs::is_directory(here_ / "deep"));
}

}  // namespace
}  // namespace enfilade
