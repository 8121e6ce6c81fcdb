#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "models/samples.h"
#include "preprocess/authored_names.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/cut_cells.h"
#include "preprocess/object_roles.h"
#include "scene/gltf_reader.h"

namespace enfilade {
namespace {

/// A building, and what its author's program says of it.
struct Model {
  const char* file;
  std::size_t doors, windows, cells, storeys;  ///< cells: rooms where only walls divide, outside
  std::vector<float> degrees;                  ///< that it is turned by
};

CellGraph graphOf(const Building& building) {
  const std::vector<ObjectRole> roles = namedRoles(building, kUsualDoors, kUsualWindows);
  const VoxelGrid voxels = voxelise(building, roles, 0.1f);
  return cutCells(voxels, findCells(building, roles, voxels, {})).graph;
}

/// The centres of a graph's doors and windows, turned back.
std::vector<glm::vec3> centersOf(const CellGraph& graph, PortalKind kind, const glm::mat3& turned) {
  std::vector<glm::vec3> centers;
  for (const Portal& portal : graph.portals) {
    if (portal.kind == kind) centers.push_back(glm::transpose(turned) * portal.center());
  }
  return centers;
}

std::size_t countNear(const std::vector<glm::vec3>& centers, const std::vector<glm::vec3>& others) {
  std::size_t count = 0;
  for (const glm::vec3& a : centers) {
    count += std::any_of(others.begin(), others.end(),
                         [&](const glm::vec3& b) { return glm::distance(a, b) < 0.15f; });
  }
  return count;
}

Building turnedBy(const Building& building, const glm::mat4& turn) {
  Building turned = building;
  for (Node& node : turned.nodes) node.world_from_node = turn * node.world_from_node;
  return turned;
}

/// Plants stand in the windows of one of its rooms, so that only parts of the openings are met.
TEST(FindCellsOfSamples, FindsTheGallerysRoomsTurnedToo) {
  Building gallery = raiseSample("gallery", 150'000);
  takeAuthoredNames(gallery);
  for (const float degrees : {17.0f, 27.0f}) {
    SCOPED_TRACE(degrees);
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
    const CellGraph graph = graphOf(turnedBy(gallery, turn));
    EXPECT_EQ(graph.cells.size(), 10u);
    EXPECT_GE(graph.portals.size(), 40u);  // of 42
    EXPECT_LE(graph.portals.size(), 45u);
  }
}

class FindCellsOfHouses : public testing::TestWithParam<const char*> {};

TEST_P(FindCellsOfHouses, FindsAllOfThemFurnished) {
  if (!std::filesystem::exists(kFurnitureFolder)) {
    GTEST_SKIP() << "sweethome3d-furniture is not installed";
  }
  Building house = raiseSample(GetParam());
  const AuthoredNames names = takeAuthoredNames(house);
  const CellGraph found = graphOf(house);
  EXPECT_EQ(found.cells.size(), names.rooms.size() + 1);
  EXPECT_EQ(found.portals.size(), names.portals.size());
  std::size_t there = 0;
  for (const auto& named : names.portals) {
    there += std::any_of(found.portals.begin(), found.portals.end(), [&](const Portal& portal) {
      return glm::distance(portal.center(), named.portal.center()) < 0.2f;
    });
  }
  EXPECT_EQ(there, names.portals.size());
}

INSTANTIATE_TEST_SUITE_P(OfThePaper, FindCellsOfHouses, testing::Values("brooks", "haunted"),
                         [](const auto& house) { return std::string(house.param); });

class FindCellsOfModels : public testing::TestWithParam<Model> {};

TEST_P(FindCellsOfModels, FindsTheDoorsAndWindowsHoweverItIsTurned) {
  const Model& model = GetParam();
  const std::string file = std::string(ENFILADE_SOURCE_DIR "/../shared/models/") + model.file;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the model " << model.file << " is not here";
  const Building building = readGltf(file);
  const CellGraph straight = graphOf(building);
  const auto doors = centersOf(straight, PortalKind::kDoor, glm::mat3(1));
  const auto windows = centersOf(straight, PortalKind::kWindow, glm::mat3(1));
  EXPECT_GE(doors.size(), model.doors);
  EXPECT_EQ(windows.size(), model.windows);
  EXPECT_GE(straight.cells.size(), model.cells);
  EXPECT_EQ(straight.storeys.size(), model.storeys);
  for (const float degrees : model.degrees) {
    SCOPED_TRACE(degrees);
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
    const CellGraph graph = graphOf(turnedBy(building, turn));
    EXPECT_GE(graph.cells.size(), model.cells);
    EXPECT_GE(countNear(doors, centersOf(graph, PortalKind::kDoor, glm::mat3(turn))), model.doors);
    // One may go by another kind: its sill lies near the ground.
    EXPECT_GE(countNear(windows, centersOf(graph, PortalKind::kWindow, glm::mat3(turn))) + 1,
              model.windows);
  }
}

INSTANTIATE_TEST_SUITE_P(Real, FindCellsOfModels,
                         testing::Values(Model{"duplex.glb", 14, 24, 15, 2, {27, 58}},
                                         Model{"bimwhale-large.glb", 18, 42, 10, 2, {8, 17}}));

}  // namespace
}  // namespace enfilade
