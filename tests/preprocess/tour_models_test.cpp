#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "models/samples.h"
#include "preprocess/authored_names.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/cut_cells.h"
#include "preprocess/tour.h"
#include "preprocess/tour_check.h"
#include "preprocess/voxel_grid.h"
#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"

namespace enfilade {
namespace {

House houseOf(Building building, const std::string& doors, const std::string& windows) {
  House house;
  const AuthoredNames names = takeAuthoredNames(building);
  house.building = std::move(building);
  for (const Object& object : house.building.objects) {
    ObjectRole role = ObjectRole::kFixed;
    if (matchesName(house.building, object, doors)) role = ObjectRole::kDoor;
    if (matchesName(house.building, object, windows)) role = ObjectRole::kGlass;
    house.object_roles.push_back(role);
  }
  const VoxelGrid voxels = voxelise(house.building, house.object_roles, 0.1f);
  const CellProposal proposal = names.empty()
                                    ? findCells(house.building, house.object_roles, voxels, {})
                                    : authoredCells(names, voxels);
  const CutCells cut = cutCells(voxels, proposal);
  house.graph = cut.graph;
  house.grid = cut.grid;
  return house;
}

void expectWhole(const House& house, const Tour& tour, std::size_t frames) {
  EXPECT_EQ(tour.path.poses.size(), frames);
  EXPECT_EQ(tour.visited.size(), house.graph.cells.size());
  for (const TourViolation& v : checkTour(house, tour.path, 0.2f)) {
    ADD_FAILURE() << "pose " << v.pose << ": " << v.what;
  }
}

TEST(TourModels, VisitsEveryRoomOfTheGalleryAndTheParkOutside) {
  const std::string file = ::testing::TempDir() + "enfilade-tour-gallery.glb";
  writeGlb(file, raiseSample("gallery", 50'000));
  const House house = houseOf(readGltf(file), "", "");
  std::filesystem::remove(file);
  ASSERT_GE(house.graph.cells.size(), 10u);
  expectWhole(house, makeTour(house, {.frames = 520}), 520);
}

TEST(TourModels, VisitsBothFlatsOfTheDuplex) {
  const std::string file = ENFILADE_SOURCE_DIR "/../shared/models/duplex.glb";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the shared models are not here";
  const House house = houseOf(readGltf(file), "IfcDoor*", "IfcWindow*");
  ASSERT_GE(house.graph.cells.size(), 12u);
  expectWhole(house, makeTour(house, {.frames = 520}), 520);
  expectWhole(house, makeTour(house, {.frames = 100}), 100);
}

}  // namespace
}  // namespace enfilade
