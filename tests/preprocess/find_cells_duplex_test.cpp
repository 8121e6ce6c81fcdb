#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>

#include "preprocess/cell_proposal.h"
#include "preprocess/cut_cells.h"
#include "scene/gltf_reader.h"

namespace enfilade {
namespace {

const std::string kModel = ENFILADE_SOURCE_DIR "/../shared/models/duplex.glb";

CellGraph graphOf(const Building& building) {
  std::vector<ObjectRole> roles;
  for (const Object& object : building.objects) {
    roles.push_back(matchesName(building, object, "IfcDoor*")     ? ObjectRole::kDoor
                    : matchesName(building, object, "IfcWindow*") ? ObjectRole::kGlass
                                                                  : ObjectRole::kFixed);
  }
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

TEST(FindCellsOfDuplex, TurnedItHasTheSameDoorsAndWindows) {
  if (!std::filesystem::exists(kModel)) GTEST_SKIP() << "the model duplex.glb is not here";
  Building building = readGltf(kModel);
  const CellGraph straight = graphOf(building);
  // What the author's program says: 14 doors; 24 windows; 14 rooms where only walls divide.
  const auto doors = centersOf(straight, PortalKind::kDoor, glm::mat3(1));
  const auto windows = centersOf(straight, PortalKind::kWindow, glm::mat3(1));
  EXPECT_GE(doors.size(), 14u);
  EXPECT_EQ(windows.size(), 24u);
  EXPECT_GE(straight.cells.size(), 15u);
  EXPECT_EQ(straight.storeys.size(), 2u);
  for (const float degrees : {27.0f, 58.0f}) {
    SCOPED_TRACE(degrees);
    const glm::mat4 turn = glm::rotate(glm::mat4(1), glm::radians(degrees), glm::vec3(0, 1, 0));
    Building turned = building;
    for (Node& node : turned.nodes) node.world_from_node = turn * node.world_from_node;
    const CellGraph graph = graphOf(turned);
    const glm::mat3 rotation(turn);
    EXPECT_GE(countNear(doors, centersOf(graph, PortalKind::kDoor, rotation)), doors.size());
    EXPECT_EQ(countNear(windows, centersOf(graph, PortalKind::kWindow, rotation)), 24u);
    EXPECT_NEAR(double(graph.cells.size()), double(straight.cells.size()), 2.0);
    EXPECT_NEAR(double(graph.portals.size()), double(straight.portals.size()), 4.0);
  }
}

}  // namespace
}  // namespace enfilade
