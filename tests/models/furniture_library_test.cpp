#include "models/furniture_library.h"

#include <gtest/gtest.h>
#include <unistd.h>
#include <zip.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include "models/java_properties.h"
#include "models/raise_building.h"
#include "scene/error.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

std::map<std::string, std::string> properties(const std::string& text) {
  return readJavaProperties({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

TEST(JavaProperties, KnowsCommentsEscapesAndLinesThatGoOn) {
  const auto read = properties(
      "# no=1\n  ! no=2\r\nname#1=Bill 10\\u20ac\n  a b=c\nlong = one, \\\n    two\nlatin=\xe9\n"
      "twice=1\ntwice=2\ndos=one \\\r\n  two\r\nkey\\ with\\=signs:x\\ty\nalone\nend\\\\=\\");
  EXPECT_EQ(read.at("name#1"), "Bill 10€");
  EXPECT_EQ(read.at("a"), "b=c");
  EXPECT_EQ(read.at("long"), "one, two");
  EXPECT_EQ(read.at("latin"), "é");
  EXPECT_EQ(read.at("twice"), "2");
  EXPECT_EQ(read.at("dos"), "one two");
  EXPECT_EQ(read.at("key with=signs"), "x\ty");
  EXPECT_EQ(read.at("alone"), "");
  EXPECT_EQ(read.at("end\\"), "");
  EXPECT_EQ(read.size(), 9u);
}

/// A folder with one catalogue: a chair of 50 x 90 x 40 cm whose OBJ is a box of other units, lying
/// on its side.
class Furniture : public testing::Test {
 protected:
  Furniture()
      : folder_(fs::temp_directory_path() / ("enfilade-furniture-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~Furniture() override { fs::remove_all(folder_); }

  void write(const std::map<std::string, std::string>& entries) {
    zip_t* zip = zip_open((folder_ / "test.sh3f").c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    for (const auto& [name, text] : entries) {
      zip_source_t* source = zip_source_buffer(zip, text.data(), text.size(), 0);
      ASSERT_GE(zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8), 0);
    }
    ASSERT_EQ(zip_close(zip), 0);
  }

  static std::string catalogue(const std::string& more = "") {
    return "license=CC0\nid#1=Test#chair\nname#1=Chair\ncategory#1=Office\nmodel#1=/a/chair.obj\n"
           "width#1=50\nheight#1=90\ndepth#1=40\ndropOnTopElevation#1=45.5\ncreator#1=Ann\n"
           "modelRotation#1=1 0 0 0 0 1 0 -1 0\n" +
           more;
  }
  static std::string box() {
    return "mtllib ../a/chair.mtl\nv 1 1 1\nv 3 1 1\nv 3 5 1\nv 1 5 1\nv 1 1 9\nv 3 1 9\nv 3 5 9\n"
           "v 1 5 9\nusemtl oak\nf 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\n";
  }
  std::string complaint() const {
    try {
      const FurnitureLibrary library(folder_.string());
      for (const auto& [id, entry] : library.entries()) library.load(entry);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(Furniture, StandsInItsSizeOnItsFoot) {
  write({{"PluginFurnitureCatalog.properties", catalogue()},
         {"a/chair.obj", box()},
         {"a/chair.mtl", "newmtl oak\nKd 0.5 0.5 0.5\n"}});
  const FurnitureLibrary library(folder_.string());
  const FurnitureEntry* chair = library.find("Test#chair");
  ASSERT_NE(chair, nullptr);
  EXPECT_EQ(library.find("Test#table"), nullptr);
  EXPECT_EQ(chair->name, "Chair");
  EXPECT_EQ(chair->creator, "Ann");
  EXPECT_EQ(chair->licence, "CC0");
  EXPECT_NEAR(chair->top, 0.455, 1e-9);
  const Building model = library.load(*chair);
  const Box bounds = worldBounds(model);
  EXPECT_NEAR(bounds.min.x, -0.25f, 1e-5f);
  EXPECT_NEAR(bounds.max.x, 0.25f, 1e-5f);
  EXPECT_NEAR(bounds.min.y, 0.0f, 1e-5f);
  EXPECT_NEAR(bounds.max.y, 0.9f, 1e-5f);
  EXPECT_NEAR(bounds.min.z, -0.2f, 1e-5f);
  EXPECT_NEAR(bounds.max.z, 0.2f, 1e-5f);
  EXPECT_EQ(model.materialOf(model.objects[0]).name, "oak");
  // What was up to z in the OBJ is up to y: its corner at z = 9 stands at the top.
  const glm::mat4& place = model.nodes[0].world_from_node;
  EXPECT_NEAR((place * glm::vec4(1, 1, 9, 1)).y, 0.9f, 1e-5f);
}

TEST_F(Furniture, WhatIsWrongIsSaid) {
  EXPECT_NE(complaint().find("sweethome3d-furniture"), std::string::npos) << complaint();
  std::ofstream(folder_ / "test.sh3f") << "no zip";
  EXPECT_NE(complaint().find("is no ZIP"), std::string::npos) << complaint();
  write({{"readme", "x"}});
  EXPECT_NE(complaint().find("is no furniture catalogue"), std::string::npos) << complaint();
  write({{"PluginFurnitureCatalog.properties", catalogue()}});
  EXPECT_NE(complaint().find("a/chair.obj: is not there"), std::string::npos) << complaint();
  write(
      {{"PluginFurnitureCatalog.properties", catalogue("width#1=wide\n")}, {"a/chair.obj", box()}});
  EXPECT_NE(complaint().find("width#1 is not 1 numbers"), std::string::npos) << complaint();
  for (const char* wrong : {"width#1=0\n", "depth#1=-50\n", "height#1=1e300\n"}) {
    write({{"PluginFurnitureCatalog.properties", catalogue(wrong)}, {"a/chair.obj", box()}});
    EXPECT_NE(complaint().find("Test#chair has a size"), std::string::npos) << complaint();
  }
  write({{"PluginFurnitureCatalog.properties", catalogue("modelRotation#1=0 0 0 0 1 0 0 0 1\n")},
         {"a/chair.obj", box()}});
  EXPECT_NE(complaint().find("that is no rotation"), std::string::npos) << complaint();
}

TEST_F(Furniture, ThatIsShearedOrAsHighAsTheMoonIsRefused) {
  write(
      {{"PluginFurnitureCatalog.properties", catalogue("modelRotation#1=1 1e300 0 0 1 0 0 0 1\n")},
       {"a/chair.obj", box()}});
  EXPECT_NE(complaint().find("that is no rotation"), std::string::npos) << complaint();
  write({{"PluginFurnitureCatalog.properties", catalogue("dropOnTopElevation#1=1e300\n")},
         {"a/chair.obj", box()}});
  EXPECT_NE(complaint().find("dropOnTopElevation of over 100 m"), std::string::npos) << complaint();
}

TEST_F(Furniture, ReadsNothingOutsideItsCatalogueAndWritesNothing) {
  const fs::path outside = folder_ / "outside.mtl";
  std::ofstream(outside) << "newmtl oak\nKd 1 0 0\n";
  for (const std::string& name : {outside.string(), std::string("../../outside.mtl")}) {
    const std::string model = "mtllib " + name + box().substr(box().find('\n'));
    write({{"PluginFurnitureCatalog.properties", catalogue()},
           {"a/chair.obj", model},
           {"../climbed.txt", "x"},
           {"/climbed.txt", "x"}});
    const FurnitureLibrary library(folder_.string());
    const Building chair = library.load(*library.find("Test#chair"));
    EXPECT_EQ(chair.materialOf(chair.objects[0]).name, "none") << name;
  }
  EXPECT_FALSE(fs::exists(folder_.parent_path() / "climbed.txt"));
  EXPECT_FALSE(fs::exists(folder_ / "climbed.txt"));
}

TEST_F(Furniture, ThatClimbsOutOfItsCatalogueIsNotThere) {
  std::ofstream(folder_ / "chair.obj") << box();
  for (const char* model : {"model#1=../../chair.obj\n", "model#1=/../chair.obj\n"}) {
    write({{"PluginFurnitureCatalog.properties", catalogue(model)}});
    EXPECT_NE(complaint().find("chair.obj: is not there"), std::string::npos) << complaint();
  }
}

TEST_F(Furniture, ThatUnpacksToAGigabyteIsRefused) {
  write({{"PluginFurnitureCatalog.properties", catalogue()}, {"a/chair.obj", box()}});
  std::ifstream stream(folder_ / "test.sh3f", std::ios::binary);
  const std::string zip{std::istreambuf_iterator<char>(stream), {}};
  const std::size_t directory = zip.find("PK\x01\x02");
  const auto complaintWith = [&](std::uint32_t size, std::uint16_t method) {
    std::string changed = zip;
    std::memcpy(changed.data() + directory + 24, &size, sizeof(size));  // unpacked
    std::memcpy(changed.data() + directory + 10, &method, sizeof(method));
    try {
      const FurnitureLibrary library({changed.begin(), changed.end()}, "bomb.sh3f");
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(complaintWith(0x40000000, ZIP_CM_DEFLATE).find("larger than 256 MiB"),
            std::string::npos);
  EXPECT_NE(complaintWith(0x0f000000, ZIP_CM_DEFLATE).find("a size that its bytes cannot hold"),
            std::string::npos);
  EXPECT_NE(complaintWith(1000, ZIP_CM_BZIP2).find("by another method than deflate"),
            std::string::npos);
}

/// A room of 4 x 3 m with two chairs, the second half as high and with a jar on it.
std::string planWithChairs(const std::string& id) {
  return R"({
    "enfilade": "plan", "version": 1, "name": "office", "triangles": 2000,
    "outside": {"ground": 0, "margin": 2, "facade": "w", "roof": "w", "floor": "w", "trim": "w"},
    "storeys": [{"floor": 0, "height": 3,
      "defaults": {"height": 2.6, "ceiling": "w", "trim": "w"},
      "walls": [{"from": [0, 0], "to": [4, 0]}, {"from": [4, 0], "to": [4, 3]},
                {"from": [4, 3], "to": [0, 3]}, {"from": [0, 3], "to": [0, 0]}],
      "rooms": [{"name": "office", "at": [2, 2], "floor": "w", "walls": "w"}],
      "fittings": [{"piece": "chair", "room": "office", "at": [1, 1], "turn": 90},
                   {"piece": "jar", "on": "low", "room": "office", "at": [3, 2]}]}],
    "pieces": {"chair": {"furniture": ")" +
         id + R"("}, "low": {"furniture": ")" + id + R"(", "height": 0.45},
               "jar": {"shape": "vase", "finish": "w", "height": 0.3}},
    "finishes": {"w": {"colors": ["#ffffff"]}}})";
}

/// Of what stands in nodes of that name.
Box boundsOf(const Building& building, const std::string& node) {
  Box bounds;
  for (const Object& object : building.objects) {
    if (building.nodes[object.node].name != node) continue;
    const Box box = worldBounds(building, object);
    bounds.extend(box.min);
    bounds.extend(box.max);
  }
  return bounds;
}

TEST_F(Furniture, StandsInRoomsAsThePlanSaysAndThanksItsMakers) {
  write({{"PluginFurnitureCatalog.properties", catalogue()},
         {"a/chair.obj", box()},
         {"a/chair.mtl", "newmtl oak\nKd 0.5 0.5 0.5\n"}});
  const FurnitureLibrary library(folder_.string());
  const FloorPlan plan = parseFloorPlan(planWithChairs("Test#chair"), "office.json");
  ASSERT_TRUE(plan.hasFurniture());
  const Building building = raiseBuilding(plan, 2000, "office.json", &library);
  const Box chair = boundsOf(building, "chair-1");
  EXPECT_NEAR(chair.size().x, 0.4f, 1e-4f) << "turned by 90 degrees";
  EXPECT_NEAR(chair.size().z, 0.5f, 1e-4f);
  EXPECT_NEAR(chair.min.y, 0.0f, 1e-4f);
  EXPECT_NEAR(chair.center().x, 1.0f, 1e-4f);
  EXPECT_NEAR(boundsOf(building, "low-1").max.y, 0.45f, 1e-4f);
  EXPECT_NEAR(boundsOf(building, "jar-1").min.y, 0.2275f, 1e-3f) << "half of 45.5 cm";
  EXPECT_NE(building.copyright.find("; Chair by Ann (CC0)"), std::string::npos);
  EXPECT_NEAR(static_cast<double>(triangleCount(building)), 2000, 40);
}

TEST_F(Furniture, ThatNoCatalogueHasIsNamed) {
  write({{"PluginFurnitureCatalog.properties", catalogue()}, {"a/chair.obj", box()}});
  const FurnitureLibrary library(folder_.string());
  const FloorPlan plan = parseFloorPlan(planWithChairs("Test#throne"), "office.json");
  try {
    raiseBuilding(plan, 2000, "office.json", &library);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "office.json: pieces.chair.furniture: no catalogue has \"Test#throne\"");
  }
}

TEST(FurnitureOfDebian, HasPiecesThatStandInTheirSize) {
  if (!fs::exists(kFurnitureFolder)) GTEST_SKIP() << "sweethome3d-furniture is not installed";
  const FurnitureLibrary library;
  EXPECT_GE(library.entries().size(), 500u);
  std::size_t looked_at = 0;
  for (const auto& [id, entry] : library.entries()) {
    if (looked_at++ % 40 != 0) continue;
    SCOPED_TRACE(id);
    const Building model = library.load(entry);
    const glm::vec3 size = worldBounds(model).size();
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(size[axis], entry.size[axis], 0.01 * entry.size[axis] + 1e-3);
    }
    EXPECT_NEAR(worldBounds(model).min.y, 0.0f, 1e-3f);
  }
}

}  // namespace
}  // namespace enfilade
