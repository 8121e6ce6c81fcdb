#include "preprocess/authored_names.h"

#include <gtest/gtest.h>

#include "preprocess/cut_cells.h"
#include "preprocess/marker_outline.h"
#include "tests/preprocess/test_building.h"

namespace enfilade {
namespace {

std::uint32_t addNode(Building& building, const std::string& name, std::uint32_t parent = kNone,
                      const std::string& extras = "") {
  Node node;
  node.name = name;
  node.parent = parent;
  node.extras = extras;
  building.nodes.push_back(node);
  return static_cast<std::uint32_t>(building.nodes.size() - 1);
}

// A fan of triangles around the polygon's corners, none of them shared.
void addMarker(Building& building, std::uint32_t node, const std::vector<glm::vec3>& corners) {
  VertexArrays vertices;
  Mesh mesh;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    for (const glm::vec3& p : {corners[0], corners[i - 1], corners[i]}) {
      mesh.indices.push_back(static_cast<std::uint32_t>(vertices.positions.size()));
      vertices.positions.push_back(p);
    }
  }
  vertices.normals.assign(vertices.positions.size(), glm::vec3(0, 1, 0));
  mesh.vertices = static_cast<std::uint32_t>(building.vertex_arrays.size());
  building.vertex_arrays.push_back(vertices);
  building.objects.push_back({node, static_cast<std::uint32_t>(building.meshes.size())});
  building.meshes.push_back(mesh);
}

const std::vector<glm::vec3> kDoor{{4, 0, 1.5f}, {4, 0, 2.5f}, {4, 2.1f, 2.5f}, {4, 2.1f, 1.5f}};

TEST(MarkerOutline, KeepsTheWindingAndLeavesOutCornersOnAnEdge) {
  Building building;
  building.materials.resize(1);
  std::vector<glm::vec3> corners = kDoor;
  corners.insert(corners.begin() + 1, glm::vec3(4, 0, 2.0f));
  addMarker(building, addNode(building, "x"), corners);
  const auto outline = outlineOf(building, building.objects[0]);
  ASSERT_EQ(outline.size(), 4u);
  EXPECT_GT(glm::dot(planeOf(outline).normal, planeOf(kDoor).normal), 0.999f);
}

TEST(MarkerOutline, AClosedBoxHasNone) {
  TestBuilding test;
  test.box({0, 0, 0}, {1, 1, 1});
  EXPECT_TRUE(outlineOf(test.building, test.building.objects[0]).empty());
}

TEST(AuthoredNames, AreTakenOffTheirEndings) {
  for (const auto& [name, room] : std::vector<std::pair<std::string, std::string>>{
           {"hall-room", "hall"},
           {"hall-room3", "hall"},
           {"hall-room_003", "hall"},
           {"hall-room.1", "hall"},
           {"a-room-room-12", "a-room"},
           {std::string(200'000, 'n') + "-room", std::string(200'000, 'n')},
           {"hall-rooms", ""},
           {"hallroom", ""},
           {"hall-room-", ""},
           {"hall-room3x", ""},
           {std::string(200'000, 'n'), ""}}) {
    Building building;
    addNode(building, name);
    const AuthoredNames names = takeAuthoredNames(building);
    if (room.empty()) {
      EXPECT_TRUE(names.rooms.empty()) << name.substr(0, 20);
    } else {
      ASSERT_EQ(names.rooms.size(), 1u) << name.substr(0, 20);
      EXPECT_EQ(names.rooms[0].name, room);
    }
  }
}

TEST(MarkerOutline, TwoPiecesHaveNone) {
  Building building;
  building.materials.resize(1);
  const std::uint32_t node = addNode(building, "x");
  addMarker(building, node, kDoor);
  Mesh& mesh = building.meshes[0];
  auto& vertices = building.vertex_arrays[0];
  for (const glm::vec3& p : {glm::vec3(9, 0, 0), glm::vec3(9, 1, 0), glm::vec3(9, 0, 1)}) {
    mesh.indices.push_back(static_cast<std::uint32_t>(vertices.positions.size()));
    vertices.positions.push_back(p);
  }
  EXPECT_TRUE(outlineOf(building, building.objects[0]).empty());
}

TestBuilding twoRooms() {
  TestBuilding test;
  test.slab(-0.2f, -0.2f, 8.2f, 4.2f, 0.0f);
  test.slab(-0.2f, -0.2f, 8.2f, 4.2f, 3.2f);
  test.wall(true, 0, 0, 8, 0, 3);
  test.wall(true, 4, 0, 8, 0, 3);
  test.wall(false, 0, 0, 4, 0, 3);
  test.wall(false, 4, 0, 4, 0, 3, {{1.5f, 2.5f, 0, 2.1f}});
  test.wall(false, 8, 0, 4, 0, 3);
  return test;
}

TEST(AuthoredNames, RoomsPortalsAndBoundsByNameBecomeCells) {
  TestBuilding test = twoRooms();
  Building& b = test.building;
  const std::size_t geometry = b.objects.size();
  const std::uint32_t kitchen = addNode(b, "kitchen-room");
  const std::uint32_t hall = addNode(b, "hall-room");
  addMarker(b, addNode(b, "hall-portal-2", kitchen), kDoor);
  TestBuilding bounds;
  bounds.box({0, 0, 0}, {4, 3, 4});
  bounds.box({4, 0, 0}, {8, 3, 4});
  for (const std::uint32_t room : {kitchen, hall}) {
    const std::size_t m = room == kitchen ? 0 : 1;
    const std::uint32_t node = addNode(b, b.nodes[room].name + "-bound", room);
    Mesh mesh = bounds.building.meshes[m];
    mesh.vertices = static_cast<std::uint32_t>(b.vertex_arrays.size());
    b.vertex_arrays.push_back(bounds.building.vertex_arrays[m]);
    b.objects.push_back({node, static_cast<std::uint32_t>(b.meshes.size())});
    b.meshes.push_back(mesh);
  }
  const AuthoredNames names = takeAuthoredNames(b);
  EXPECT_EQ(b.objects.size(), geometry) << "markers are no part of the picture";
  ASSERT_EQ(names.rooms.size(), 2u);
  ASSERT_EQ(names.portals.size(), 1u);
  EXPECT_EQ(names.portals[0].from, "kitchen");
  EXPECT_EQ(names.portals[0].to, "hall");
  EXPECT_FALSE(names.empty());

  const VoxelGrid voxels = voxelise(b, test.roles, 0.1f);
  const CutCells cut = cutCells(voxels, authoredCells(names, voxels));
  ASSERT_EQ(cut.graph.cells.size(), 3u);
  EXPECT_EQ(cut.graph.cells[1].name, "kitchen");
  EXPECT_EQ(cut.graph.cells[2].name, "hall");
  ASSERT_EQ(cut.graph.portals.size(), 1u);
  EXPECT_EQ(locate(cut.graph, cut.grid, {1, 1.6f, 2}).cell, 1u);
  EXPECT_EQ(locate(cut.graph, cut.grid, {7, 1.6f, 2}).cell, 2u);
}

TEST(AuthoredNames, ExtrasSayTheSame) {
  Building b;
  b.materials.resize(1);
  const std::uint32_t room = addNode(b, "Küche", kNone, R"({"cell": "kitchen"})");
  addMarker(b,
            addNode(b, "to the hall", room,
                    R"({"portal": {"kind": "door", "to": "hall", "two_way": false}})"),
            kDoor);
  const AuthoredNames names = takeAuthoredNames(b);
  ASSERT_EQ(names.rooms.size(), 1u);
  EXPECT_EQ(names.rooms[0].name, "kitchen");
  ASSERT_EQ(names.portals.size(), 1u);
  EXPECT_EQ(names.portals[0].to, "hall");
  EXPECT_EQ(names.portals[0].portal.kind, PortalKind::kDoor);
  EXPECT_FALSE(names.portals[0].portal.two_way);
}

TEST(AuthoredNames, ExtrasOfAnotherTypeSayNothing) {
  Building b;
  b.materials.resize(1);
  const std::uint32_t room = addNode(b, "kitchen-room");
  addMarker(b,
            addNode(b, "hall-portal", room,
                    R"({"portal": {"kind": 5, "to": null, "two_way": "no", "active": []}})"),
            kDoor);
  const AuthoredNames names = takeAuthoredNames(b);
  ASSERT_EQ(names.portals.size(), 1u);
  EXPECT_EQ(names.portals[0].portal.kind, PortalKind::kOpening);
  EXPECT_EQ(names.portals[0].to, "hall");
  EXPECT_TRUE(names.portals[0].portal.two_way && names.portals[0].portal.active);
}

TEST(AuthoredNames, OrdinaryNamesAreLeftAlone) {
  TestBuilding test = twoRooms();
  test.building.nodes[0].name = "portal";
  test.building.nodes[1].name = "bathroom-";
  const std::size_t geometry = test.building.objects.size();
  EXPECT_TRUE(takeAuthoredNames(test.building).empty());
  EXPECT_EQ(test.building.objects.size(), geometry);
}

TEST(AuthoredNames, APortalThatIsNoFlatPieceIsLeftOutWithAWarning) {
  TestBuilding test;
  test.box({0, 0, 0}, {1, 1, 1});
  const std::uint32_t room = addNode(test.building, "hall-room");
  test.building.objects[0].node = addNode(test.building, "kitchen-portal", room);
  const AuthoredNames names = takeAuthoredNames(test.building);
  EXPECT_TRUE(names.portals.empty());
  ASSERT_EQ(names.warnings.size(), 1u);
  EXPECT_NE(names.warnings[0].find("kitchen-portal"), std::string::npos);
}

}  // namespace
}  // namespace enfilade
