#include "preprocess/preprocess.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "models/samples.h"
#include "preprocess/tour.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/gltf_writer.h"
#include "tests/preprocess/test_building.h"
#include "visibility/object_index.h"
#include "visibility/portal_culling.h"

namespace enfilade {
namespace {

namespace fs = std::filesystem;

const std::string kDuplex = ENFILADE_SOURCE_DIR "/../shared/models/duplex.glb";

// A folder of its own for each test, removed afterwards.
class Preprocess : public testing::Test {
 protected:
  Preprocess()
      : root_(fs::temp_directory_path() /
              ("enfilade-preprocess-" + std::to_string(getpid()) + "-" +
               testing::UnitTest::GetInstance()->current_test_info()->name())) {
    fs::create_directories(root_);
  }
  ~Preprocess() override { fs::remove_all(root_); }

  std::string path(const std::string& name) const { return (root_ / name).string(); }

 private:
  fs::path root_;
};

PreprocessParameters withoutImages() {
  PreprocessParameters parameters;
  parameters.images = false;
  return parameters;
}

// Every file of a folder with its content, by name.
std::vector<std::pair<std::string, std::vector<std::uint8_t>>> contentOf(
    const std::string& folder) {
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    files.emplace_back(fs::relative(entry.path(), folder).string(),
                       readFile(entry.path().string()));
  }
  std::sort(files.begin(), files.end());
  return files;
}

// The largest share of pixels, over the poses of the house's own tour, in which culling by portals
// differs from the whole building, drawn to the last triangle.
double largestDifference(const House& house, int frames, std::size_t& whole, std::size_t& culled) {
  const auto context = createOsMesaContext();
  Renderer renderer(*context, house.building);
  const ObjectIndex index(house);
  TourParameters parameters;
  parameters.frames = frames;
  const Tour tour = makeTour(house, parameters);
  double largest = 0;
  Image expected, seen;
  for (const TimedPose& timed : tour.path.poses) {
    Camera camera;
    camera.pose = timed.pose;
    const View view = camera.view();
    renderer.begin(320, 256);
    renderer.setSifting(false);
    whole += renderer.draw(index.inFrustum(view), view).triangles;
    renderer.readColor(expected);
    const CellId cell = locate(house.graph, house.grid, view.eye).cell;
    renderer.begin(320, 256);
    renderer.setSifting(true);
    culled += renderer.draw(index.visible(cullByPortals(house.graph, view, cell)), view).triangles;
    renderer.readColor(seen);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < seen.rgba.size(); i += 4) {
      differing += !std::equal(&seen.rgba[i], &seen.rgba[i] + 4, &expected.rgba[i]);
    }
    largest = std::max(largest,
                       static_cast<double>(4 * differing) / static_cast<double>(seen.rgba.size()));
  }
  return largest;
}

TEST_F(Preprocess, CullingIsThePictureOfTheWholeGalleryToThePixel) {
  writeGlb(path("gallery.glb"), raiseSample("gallery", 50000));
  const House house = preprocessBuilding(path("gallery.glb"), path("house"), withoutImages()).house;
  EXPECT_EQ(house.graph.cells.size(), 10u);
  EXPECT_TRUE(diagnose(house.graph).empty());
  std::size_t whole = 0, culled = 0;
  EXPECT_EQ(largestDifference(house, 130, whole, culled), 0.0);
  EXPECT_LT(2 * culled, whole);
}

// The mean green of the floor's vertices between two values of x, 0…1.
double floorLight(const Building& building, float from_x, float to_x) {
  double sum = 0;
  int count = 0;
  for (const Object& object : building.objects) {
    const VertexArrays& vertices = building.vertex_arrays[building.meshOf(object).vertices];
    for (std::size_t i = 0; i < vertices.positions.size(); ++i) {
      const glm::vec3& p = vertices.positions[i];
      if (std::abs(p.y) > 1e-3f || p.x < from_x || p.x > to_x || p.z < 0.5f || p.z > 3.5f) continue;
      sum += vertices.colors[i].g / 65535.0;
      ++count;
    }
  }
  EXPECT_GT(count, 20);
  return sum / count;
}

TEST_F(Preprocess, BakesTheLightThatComesThroughTheWindowsItFound) {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.1f}}, {{1, 3, 0.9f, 2.1f}});
  writeGlb(path("rooms.glb"), test.building);
  PreprocessParameters parameters = withoutImages();
  parameters.bake_light = true;
  const House house = preprocessBuilding(path("rooms.glb"), path("house"), parameters).house;
  EXPECT_EQ(house.info.parameters.at("bake_light"), "true");
  for (const Object& object : house.building.objects) {
    EXPECT_TRUE(house.building.materialOf(object).unlit);
  }
  const double at_window = floorLight(house.building, 6.5f, 7.5f);
  const double at_door = floorLight(house.building, 4.3f, 5.0f);
  const double beyond = floorLight(house.building, 0.5f, 1.5f);
  EXPECT_GT(at_window, at_door);
  EXPECT_GT(at_door, 1.2 * beyond);
  EXPECT_GT(beyond, 0);
  std::size_t whole = 0, culled = 0;
  EXPECT_EQ(largestDifference(house, 60, whole, culled), 0.0);
}

// The cell of `other` that shares the most of cell `id` at 1.2 m above the ground.
CellId mostCommonCell(const CellGrid& grid, CellId id, const CellGrid& other) {
  std::map<CellId, int> shared;
  const int y = grid.voxelOf({0, 1.2f, 0}).y;
  for (int x = 0; x < grid.size().x; ++x) {
    for (int z = 0; z < grid.size().z; ++z) {
      if (grid.labelAt({x, y, z}) != id) continue;
      ++shared[other.labelAt(other.voxelOf(grid.centerOf({x, y, z})))];
    }
  }
  const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
  return std::max_element(shared.begin(), shared.end(), less)->first;
}

TEST_F(Preprocess, TheGallerysRoomsAreFoundWithoutTheirNamesToo) {
  writeGlb(path("gallery.glb"), raiseSample("gallery", 50000));
  PreprocessParameters parameters = withoutImages();
  parameters.rays_per_cell = 0;  // no picture is made of this one
  const House named = preprocessBuilding(path("gallery.glb"), path("named"), parameters).house;
  parameters.rays_per_cell = PreprocessParameters().rays_per_cell;
  parameters.automatic = true;
  const House found = preprocessBuilding(path("gallery.glb"), path("found"), parameters).house;
  std::set<CellId> cells;
  for (CellId id = 1; id < named.graph.cells.size(); ++id) {
    cells.insert(mostCommonCell(named.grid, id, found.grid));
  }
  // Each room is a cell of its own, and there are no others: neither the insides of walls nor the
  // orangery, nearly all of whose walls are windows, which may not count as outdoors.
  cells.erase(kExterior);
  EXPECT_EQ(cells.size(), 9u);
  EXPECT_EQ(found.graph.cells.size(), 10u);
  // Bars divide the windows into panes, but not into portals.
  EXPECT_EQ(found.graph.portals.size(), named.graph.portals.size());
  std::size_t whole = 0, culled = 0;
  EXPECT_LE(largestDifference(found, 60, whole, culled), 1e-4);
}

TEST_F(Preprocess, WhereEverythingIsNamedNothingElseIsFound) {
  writeGlb(path("gallery.glb"), raiseSample("gallery", 50000));
  PreprocessParameters parameters = withoutImages();
  parameters.rays_per_cell = 0;
  const House mixed = preprocessBuilding(path("gallery.glb"), path("mixed"), parameters).house;
  parameters.named_only = true;
  const House named = preprocessBuilding(path("gallery.glb"), path("named"), parameters).house;
  EXPECT_EQ(mixed.info.parameters.at("cells"), "mixed");
  EXPECT_EQ(named.info.parameters.at("cells"), "authored");
  ASSERT_EQ(mixed.graph.cells.size(), named.graph.cells.size());
  for (std::size_t c = 0; c < named.graph.cells.size(); ++c) {
    EXPECT_EQ(mixed.graph.cells[c].name, named.graph.cells[c].name);
    // But for what is sealed in, as sculptures are, and which is nobody's.
    const float volume = named.graph.cells[c].volume;
    EXPECT_NEAR(mixed.graph.cells[c].volume, volume, 0.01f * volume);
  }
  ASSERT_EQ(mixed.graph.portals.size(), named.graph.portals.size());
  for (std::size_t p = 0; p < named.graph.portals.size(); ++p) {
    EXPECT_EQ(mixed.graph.portals[p].name, named.graph.portals[p].name);
    EXPECT_EQ(mixed.graph.portals[p].polygon, named.graph.portals[p].polygon);
  }
}

TEST_F(Preprocess, CullingIsThePictureOfARealHouse) {
  if (!fs::exists(kDuplex)) GTEST_SKIP() << "no ../shared/models/duplex.glb beside this checkout";
  PreprocessParameters parameters = withoutImages();
  parameters.doors = "IfcDoor*";
  parameters.windows = "IfcWindow*";
  const House house = preprocessBuilding(kDuplex, path("house"), parameters).house;
  EXPECT_GE(house.graph.cells.size(), 16u);
  std::size_t whole = 0, culled = 0;
  EXPECT_LE(largestDifference(house, 130, whole, culled), 1e-4);
  EXPECT_LT(2 * culled, whole);
}

// Two small rooms and the doorway between them, named by their author.
void writeTwoRooms(const std::string& file) {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.1f}});
  test.box({6, 0, 1}, {6.5f, 1, 1.5f});
  writeGlb(file, test.building);
}

std::string objOf(const Building& building) {
  std::string text;
  std::size_t first = 1;
  for (const Object& object : building.objects) {
    const Mesh& mesh = building.meshOf(object);
    const auto& positions = building.vertex_arrays[mesh.vertices].positions;
    text += "o " + building.nodes[object.node].name + "\n";
    for (const glm::vec3& p : positions) text += fmt::format("v {} {} {}\n", p.x, p.y, p.z);
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      text += fmt::format("f {} {} {}\n", first + mesh.indices[i], first + mesh.indices[i + 1],
                          first + mesh.indices[i + 2]);
    }
    first += positions.size();
  }
  return text;
}

TEST_F(Preprocess, TakesAWavefrontObjToo) {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.1f}});
  test.box({3.98f, 0, 1.5f}, {4.02f, 2.1f, 2.5f}, ObjectRole::kDoor);  // a shut leaf
  test.building.nodes.back().name = "Door_3";
  std::ofstream(path("rooms.obj")) << objOf(test.building);
  const House house = preprocessBuilding(path("rooms.obj"), path("house"), withoutImages()).house;
  EXPECT_EQ(house.graph.cells.size(), 3u);
  ASSERT_EQ(house.graph.portals.size(), 1u);
  EXPECT_EQ(house.graph.portals[0].kind, PortalKind::kDoor);
  EXPECT_EQ(readHouse(path("house")).info.model_name, "rooms.obj");
}

TEST_F(Preprocess, TheSameBytesForAnyNumberOfThreads) {
  writeTwoRooms(path("rooms.glb"));
  PreprocessParameters parameters;
  parameters.image.image_size = 64;
  parameters.rays_per_cell = 20000;
  parameters.threads = 1;
  const auto one = preprocessBuilding(path("rooms.glb"), path("one"), parameters);
  parameters.threads = 2;
  preprocessBuilding(path("rooms.glb"), path("two"), parameters);
  EXPECT_EQ(one.images, 2u);
  const auto files = contentOf(path("one"));
  EXPECT_EQ(files.size(), 5u);  // house.json, geometry.glb, cells.grid and two LDIs
  EXPECT_EQ(files, contentOf(path("two")));
}

TEST_F(Preprocess, AnOldHouseIsReplacedAndItsImagesGo) {
  writeTwoRooms(path("rooms.glb"));
  PreprocessParameters parameters;
  parameters.image.image_size = 32;
  parameters.rays_per_cell = 0;
  preprocessBuilding(path("rooms.glb"), path("house"), parameters);
  EXPECT_TRUE(fs::exists(path("house") + "/images"));
  parameters.images = false;
  preprocessBuilding(path("rooms.glb"), path("house"), parameters);
  EXPECT_FALSE(fs::exists(path("house") + "/images"));
  EXPECT_EQ(readHouse(path("house")).graph.cells.size(), 3u);
}

TEST_F(Preprocess, AFolderThatHoldsOtherThingsIsRefusedAndKept) {
  writeTwoRooms(path("rooms.glb"));
  fs::create_directories(path("photos"));
  writeFileAtomically(path("photos") + "/holiday.jpg", std::string("x"));
  try {
    preprocessBuilding(path("rooms.glb"), path("photos"), withoutImages());
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kUsage);
    EXPECT_NE(std::string(error.what()).find("holiday.jpg"), std::string::npos);
  }
  EXPECT_EQ(contentOf(path("photos")).size(), 1u);
}

TEST_F(Preprocess, AModelThatCannotBeReadLeavesNoFolderBehind) {
  writeFileAtomically(path("text.glb"), std::string("not a model"));
  EXPECT_THROW(preprocessBuilding(path("text.glb"), path("house"), {}), Error);
  EXPECT_FALSE(fs::exists(path("house")));
}

}  // namespace
}  // namespace enfilade
