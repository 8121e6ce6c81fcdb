#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "preprocess/cell_proposal.h"
#include "preprocess/cut_cells.h"
#include "test_building.h"

namespace enfilade {
namespace {

struct Found {
  VoxelGrid voxels;
  CellProposal proposal;
  CutCells cut;
};

Found find(const TestBuilding& test, const CellParameters& parameters = {}) {
  Found found;
  found.voxels = voxelise(test.building, test.roles, parameters.voxel);
  found.proposal = findCells(test.building, test.roles, found.voxels, parameters);
  found.cut = cutCells(found.voxels, found.proposal);
  return found;
}

std::vector<Portal> portalsOf(const Found& found, PortalKind kind) {
  std::vector<Portal> portals;
  for (const Portal& portal : found.cut.graph.portals) {
    if (portal.kind == kind) portals.push_back(portal);
  }
  return portals;
}

std::string story(const Found& found) {
  std::string text;
  for (const Cell& cell : found.cut.graph.cells) text += cell.name + "\n";
  for (const Portal& portal : found.cut.graph.portals) {
    const glm::vec3 c = portal.center();
    text += portal.name + " at " + std::to_string(c.x) + " " + std::to_string(c.y) + " " +
            std::to_string(c.z) + "\n";
  }
  for (const std::string& line : found.cut.log) text += "log: " + line + "\n";
  return text;
}

float widthOf(const Portal& portal) { return glm::distance(portal.polygon[0], portal.polygon[1]); }
float heightOf(const Portal& portal) { return glm::distance(portal.polygon[1], portal.polygon[2]); }

constexpr float kHeight = 2.6f;

/// Four outer walls, floor and ceiling around x 0…x1, z 0…z1 (middle of the walls).
void shell(TestBuilding& test, float x1, float z1,
           const std::vector<TestBuilding::Hole>& south = {}) {
  test.slab(-0.1f, -0.1f, x1 + 0.1f, z1 + 0.1f, 0.0f);
  test.slab(-0.1f, -0.1f, x1 + 0.1f, z1 + 0.1f, kHeight + 0.2f);
  test.wall(true, 0.0f, -0.1f, x1 + 0.1f, 0, kHeight, south);
  test.wall(true, z1, -0.1f, x1 + 0.1f, 0, kHeight);
  test.wall(false, 0.0f, 0.1f, z1 - 0.1f, 0, kHeight);
  test.wall(false, x1, 0.1f, z1 - 0.1f, 0, kHeight);
}

/// Two rooms of 4 × 5 m with a doorway of 0.9 × 2.05 m at (4, z 2…2.9).
void twoRooms(TestBuilding& test) {
  shell(test, 8, 5);
  test.wall(false, 4.0f, 0.1f, 4.9f, 0, kHeight, {{2.0f, 2.9f, 0.0f, 2.05f}});
}

TEST(FindCells, TwoRoomsAndADoorFitTheDoorway) {
  for (const float degrees : {0.0f, 17.0f, 30.0f, 45.0f, 71.0f}) {
    SCOPED_TRACE(degrees);
    TestBuilding test;
    const float angle = degrees * std::numbers::pi_v<float> / 180;
    test.turn(angle);
    twoRooms(test);
    const Found found = find(test);
    ASSERT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
    ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
    const Portal& door = found.cut.graph.portals[0];
    EXPECT_EQ(door.kind, PortalKind::kDoor);
    EXPECT_EQ(std::min(door.front, door.back), 1u);
    EXPECT_EQ(std::max(door.front, door.back), 2u);
    const glm::mat3 turned(glm::rotate(glm::mat4(1), angle, glm::vec3(0, 1, 0)));
    const glm::vec3 center = glm::transpose(turned) * door.center();
    EXPECT_NEAR(center.x, 4.0f, 0.03f);
    EXPECT_NEAR(center.z, 2.45f, 0.05f);
    EXPECT_NEAR(center.y, 1.025f, 0.05f);
    EXPECT_NEAR(widthOf(door), 0.9f, 0.1f);
    EXPECT_NEAR(heightOf(door), 2.05f, 0.1f);
    EXPECT_GT(std::abs(glm::dot(door.plane.normal, turned * glm::vec3(1, 0, 0))), 0.999f);
  }
}

TEST(FindCells, EveryPortalIsSoundAndCountsAsItsFrontCellSeesIt) {
  TestBuilding test;
  twoRooms(test);
  const Found found = find(test);
  for (const std::string& line : diagnose(found.cut.graph)) {
    EXPECT_NE(line.find("exterior"), std::string::npos) << line;  // it has no portal here
  }
  for (const Portal& portal : found.proposal.portals) {
    const glm::vec3 front = portal.center() + portal.plane.normal * 0.5f;
    const glm::ivec3 v = found.voxels.voxelOf(front);
    EXPECT_EQ(found.proposal.owner[found.voxels.index(v.x, v.y, v.z)], portal.front);
  }
}

TEST(FindCells, ALoopOfRoomsKeepsAllItsDoors) {
  TestBuilding test;
  shell(test, 8, 8);
  test.wall(true, 4.0f, 0.1f, 7.9f, 0, kHeight, {{1.5f, 2.4f, 0, 2.1f}, {5.5f, 6.4f, 0, 2.1f}});
  test.wall(false, 4.0f, 0.1f, 3.9f, 0, kHeight, {{1.5f, 2.4f, 0, 2.1f}});
  test.wall(false, 4.0f, 4.1f, 7.9f, 0, kHeight, {{5.5f, 6.4f, 0, 2.1f}});
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 5u) << story(found);
  EXPECT_EQ(portalsOf(found, PortalKind::kDoor).size(), 4u) << story(found);
  EXPECT_EQ(found.cut.graph.portals.size(), 4u) << story(found);
}

TEST(FindCells, AnLShapedRoomIsOneCell) {
  TestBuilding test;
  for (const float top : {0.0f, kHeight + 0.2f}) {
    test.slab(-0.1f, -0.1f, 8.1f, 4.1f, top);
    test.slab(-0.1f, 4.1f, 4.1f, 8.1f, top);
  }
  test.wall(true, 0.0f, -0.1f, 8.1f, 0, kHeight);
  test.wall(true, 4.0f, 3.9f, 8.1f, 0, kHeight);
  test.wall(true, 8.0f, -0.1f, 4.1f, 0, kHeight);
  test.wall(false, 0.0f, 0.1f, 7.9f, 0, kHeight);
  test.wall(false, 4.0f, 4.1f, 7.9f, 0, kHeight);
  test.wall(false, 8.0f, 0.1f, 3.9f, 0, kHeight);
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 2u) << story(found);
  EXPECT_TRUE(found.cut.graph.portals.empty()) << story(found);
}

TEST(FindCells, WindowsAreWindowsGlazedOrNot) {
  for (const bool glazed : {true, false}) {
    SCOPED_TRACE(glazed);
    TestBuilding test;
    shell(test, 5, 5, {{1.5f, 3.0f, 0.9f, 2.2f}});
    if (glazed) test.box({1.5f, 0.9f, -0.01f}, {3.0f, 2.2f, 0.01f}, ObjectRole::kFixed, true);
    const Found found = find(test);
    ASSERT_EQ(found.cut.graph.cells.size(), 2u) << story(found);
    const auto windows = portalsOf(found, PortalKind::kWindow);
    ASSERT_EQ(windows.size(), 1u) << story(found);
    EXPECT_NEAR(glm::distance(windows[0].center(), glm::vec3(2.25f, 1.55f, 0)), 0.0f, 0.06f);
    EXPECT_NEAR(widthOf(windows[0]), 1.5f, 0.1f);
    EXPECT_NEAR(heightOf(windows[0]), 1.3f, 0.1f);
  }
}

TEST(FindCells, ADoorThatStandsShutIsAPortalOnlyIfItIsNamed) {
  for (const bool named : {true, false}) {
    SCOPED_TRACE(named);
    TestBuilding test;
    twoRooms(test);
    test.box({3.97f, 0, 2.0f}, {4.03f, 2.05f, 2.9f},
             named ? ObjectRole::kDoor : ObjectRole::kFixed);
    const Found found = find(test);
    EXPECT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
    EXPECT_EQ(portalsOf(found, PortalKind::kDoor).size(), named ? 1u : 0u) << story(found);
  }
}

TEST(FindCells, FurnitureMakesNoCellsAndBreaksNoDoorway) {
  TestBuilding test;
  twoRooms(test);
  test.box({1.0f, 0.7f, 2.0f}, {2.5f, 0.75f, 3.0f});      // a table top
  test.box({0.1f, 0, 0.1f}, {0.7f, 2.0f, 2.0f});          // a wardrobe
  test.box({5.0f, 0, 0.1f}, {7.0f, 0.5f, 2.2f});          // a bed
  test.box({6.9f, 1.4f, 3.0f}, {7.9f, 2.2f, 4.9f});       // cupboards on the wall
  test.box({2.0f, 2.2f, 4.0f}, {2.05f, kHeight, 4.05f});  // a lamp
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  EXPECT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
}

/// Ground floor, an upper floor with a hole of 1 × 3 m at the east, and steps up to it.
void twoStoreys(TestBuilding& test) {
  test.slab(-0.1f, -0.1f, 6.1f, 5.1f, 0.0f);
  test.slab(-0.1f, -0.1f, 4.9f, 5.1f, 3.0f, 0.3f);
  test.slab(4.9f, -0.1f, 6.1f, 1.0f, 3.0f, 0.3f);
  test.slab(4.9f, 4.0f, 6.1f, 5.1f, 3.0f, 0.3f);
  test.slab(-0.1f, -0.1f, 6.1f, 5.1f, 6.0f);
  for (const float z : {0.0f, 5.0f}) test.wall(true, z, -0.1f, 6.1f, 0, 5.8f);
  for (const float x : {0.0f, 6.0f}) test.wall(false, x, 0.1f, 4.9f, 0, 5.8f);
  for (int i = 0; i < 14; ++i) {
    const float top = 3.0f * float(i + 1) / 15;
    test.box({5.0f, top - 0.2f, 0.8f + 0.2f * float(i)}, {5.9f, top, 1.0f + 0.2f * float(i)});
  }
}

TEST(FindCells, TwoStoreysMeetInTheStairwellsFloorPlane) {
  TestBuilding test;
  twoStoreys(test);
  const Found found = find(test);
  ASSERT_EQ(found.proposal.storeys.size(), 2u) << story(found);
  EXPECT_NEAR(found.proposal.storeys[0].floor_y, 0.0f, 0.02f);
  EXPECT_NEAR(found.proposal.storeys[1].floor_y, 3.0f, 0.02f);
  ASSERT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
  const Portal& stairwell = found.cut.graph.portals[0];
  EXPECT_EQ(stairwell.kind, PortalKind::kOpening);
  EXPECT_GT(std::abs(stairwell.plane.normal.y), 0.99f);
  EXPECT_NEAR(stairwell.center().y, 2.95f, 0.25f);
  EXPECT_EQ(found.cut.graph.cells[2].name, "storey-2 room-1");
}

TEST(FindCells, ALowStepDoesNotPassForTheFloorOfItsStorey) {
  TestBuilding test;
  twoStoreys(test);
  test.box({1, 3.0f, 1}, {3, 3.15f, 3});
  test.box({1, 3.15f, 1}, {2, 3.25f, 2});
  const Found found = find(test);
  ASSERT_EQ(found.proposal.storeys.size(), 2u) << story(found);
  EXPECT_NEAR(found.proposal.storeys[1].floor_y, 3.0f, 0.02f);
  ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
  const Portal& stairwell = found.cut.graph.portals[0];
  EXPECT_NEAR(stairwell.center().y, 2.95f, 0.25f);
  EXPECT_NEAR(stairwell.area(), 3.0f, 0.3f);
}

TEST(FindCells, MuchGroundAroundAHouseDoesNotPassForItsFloor) {
  TestBuilding test;
  twoStoreys(test);
  test.slab(-15, -15, 21, 20, -0.4f, 0.1f);
  const Found found = find(test);
  ASSERT_EQ(found.proposal.storeys.size(), 2u) << story(found);
  EXPECT_NEAR(found.proposal.storeys[0].floor_y, 0.0f, 0.02f);
  EXPECT_NEAR(found.proposal.storeys[1].floor_y, 3.0f, 0.02f);
}

TEST(FindCells, ARoomOverTwoStoreysIsOneCell) {
  TestBuilding test;
  // A hall of 4 × 5 m over both storeys, beside it a room on each, with a door to the hall below.
  test.slab(-0.1f, -0.1f, 8.1f, 5.1f, 0.0f);
  test.slab(4.1f, 0.1f, 7.9f, 4.9f, 3.0f, 0.3f);
  test.slab(-0.1f, -0.1f, 8.1f, 5.1f, 6.0f);
  for (const float z : {0.0f, 5.0f}) test.wall(true, z, -0.1f, 8.1f, 0, 5.8f);
  for (const float x : {0.0f, 8.0f}) test.wall(false, x, 0.1f, 4.9f, 0, 5.8f);
  test.wall(false, 4.0f, 0.1f, 4.9f, 0, 2.7f, {{2, 2.9f, 0, 2.1f}});
  test.wall(false, 4.0f, 0.1f, 4.9f, 2.7f, 5.8f, {{2, 2.9f, 3.0f, 5.1f}});
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 4u) << story(found);
  EXPECT_EQ(portalsOf(found, PortalKind::kDoor).size(), 2u) << story(found);
  EXPECT_EQ(found.cut.graph.portals.size(), 2u) << story(found);
}

TEST(FindCells, AModelWithoutARoofHasRoomsThatEndAtTheTopOfTheirWalls) {
  TestBuilding test;
  test.slab(-0.1f, -0.1f, 8.1f, 5.1f, 0.0f);
  for (const float z : {0.0f, 5.0f}) test.wall(true, z, -0.1f, 8.1f, 0, kHeight);
  for (const float x : {0.0f, 8.0f}) test.wall(false, x, 0.1f, 4.9f, 0, kHeight);
  test.wall(false, 4.0f, 0.1f, 4.9f, 0, kHeight, {{2.0f, 2.9f, 0.0f, 2.05f}});
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  EXPECT_EQ(portalsOf(found, PortalKind::kDoor).size(), 1u) << story(found);
  EXPECT_EQ(found.cut.graph.portals.size(), 3u) << story(found);
}

TEST(FindCells, ARoomWithinARoomHasItsOwnDoor) {
  TestBuilding test;
  shell(test, 9, 9);
  for (const float z : {3.0f, 6.0f}) test.wall(true, z, 2.9f, 6.1f, 0, kHeight);
  test.wall(false, 3.0f, 3.1f, 5.9f, 0, kHeight, {{4.0f, 4.9f, 0, 2.1f}});
  test.wall(false, 6.0f, 3.1f, 5.9f, 0, kHeight);
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  EXPECT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
}

TEST(FindCells, TheInsideOfAThickWallIsNoRoom) {
  TestBuilding test;
  shell(test, 9, 5);
  test.box({4, 0, 0.1f}, {4.9f, kHeight, 4.9f});
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
}

TEST(FindCells, OddDoorsAreFound) {
  struct Size {
    float width, height, thickness;
  };
  for (const Size& size :
       {Size{0.6f, 1.9f, 0.1f}, Size{1.8f, 2.2f, 0.45f}, Size{2.8f, 2.3f, 0.3f}}) {
    SCOPED_TRACE(size.width);
    TestBuilding test;
    shell(test, 10, 5);
    test.wall(false, 5.0f, 0.1f, 4.9f, 0, kHeight, {{1.0f, 1.0f + size.width, 0, size.height}},
              size.thickness);
    const Found found = find(test);
    ASSERT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
    const auto doors = portalsOf(found, PortalKind::kDoor);
    ASSERT_EQ(doors.size(), 1u) << story(found);
    EXPECT_NEAR(widthOf(doors[0]), size.width, 0.1f);
    EXPECT_NEAR(doors[0].center().x, 5.0f, 0.03f);
  }
}

TEST(FindCells, ACrackBetweenRoomsIsClosedOrTheRoomsAreOne) {
  for (const float width : {0.25f, 0.35f, 0.45f}) {
    SCOPED_TRACE(width);
    TestBuilding test;
    shell(test, 8, 5);
    test.wall(false, 4.0f, 0.1f, 4.9f, 0, kHeight, {{2.0f, 2.0f + width, 0.0f, kHeight}});
    const Found found = find(test);
    // Whatever it is called, each of the two cells must be whole and the crack a portal, or else
    // there is but one cell.
    const std::size_t cells = found.cut.graph.cells.size();
    EXPECT_TRUE(cells == 2u || (cells == 3u && found.cut.graph.portals.size() == 1u))
        << story(found);
  }
}

TEST(FindCells, BarsDivideAWindowIntoNoMoreThanOne) {
  for (const float degrees : {0.0f, 17.0f}) {
    SCOPED_TRACE(degrees);
    TestBuilding test;
    test.turn(degrees * std::numbers::pi_v<float> / 180);
    shell(test, 5, 5, {{1.0f, 3.0f, 0.7f, 2.3f}});
    for (const float x : {1.5f, 2.0f, 2.5f}) {
      test.box({x - 0.03f, 0.7f, -0.03f}, {x + 0.03f, 2.3f, 0.03f});
    }
    test.box({1.0f, 1.47f, -0.03f}, {3.0f, 1.53f, 0.03f});
    const Found found = find(test);
    ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
    const Portal& window = found.cut.graph.portals[0];
    EXPECT_EQ(window.kind, PortalKind::kWindow);
    EXPECT_NEAR(widthOf(window), 2.0f, 0.1f);
    EXPECT_NEAR(heightOf(window), 1.6f, 0.1f);
  }
}

TEST(FindCells, TwoWindowsWithAPierBetweenStayTwo) {
  TestBuilding test;
  shell(test, 6, 5, {{1.0f, 2.0f, 0.9f, 2.2f}, {2.4f, 3.4f, 0.9f, 2.2f}});
  const Found found = find(test);
  EXPECT_EQ(portalsOf(found, PortalKind::kWindow).size(), 2u) << story(found);
}

TEST(FindCells, ARoomWhoseWallsAreAllWindowIsARoom) {
  TestBuilding test;
  const float high = 3.6f;
  test.slab(-0.1f, -0.1f, 8.1f, 5.1f, 0.0f);
  test.slab(-0.1f, -0.1f, 8.1f, 5.1f, high + 0.2f);
  const std::vector<TestBuilding::Hole> bays{
      {0.4f, 2.2f, 0.5f, 3.1f}, {2.6f, 4.4f, 0.5f, 3.1f}, {4.8f, 6.6f, 0.5f, 3.1f}};
  for (const float z : {0.0f, 5.0f}) test.wall(true, z, -0.1f, 8.1f, 0, high, bays);
  const std::vector<TestBuilding::Hole> ends{{0.5f, 2.2f, 0.5f, 3.1f}, {2.7f, 4.5f, 0.5f, 3.1f}};
  for (const float x : {0.0f, 8.0f}) test.wall(false, x, 0.1f, 4.9f, 0, high, ends);
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 2u) << story(found);
  EXPECT_EQ(portalsOf(found, PortalKind::kWindow).size(), 10u) << story(found);
}

TEST(FindCells, TheInsideOfALargePierIsNoRoom) {
  TestBuilding test;
  shell(test, 9, 6);
  test.box({3, 0, 0.1f}, {6, kHeight, 3});
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 2u) << story(found);
}

TEST(FindCells, ASealedRoomBetweenWallsIsARoomStill) {
  TestBuilding test;
  twoRooms(test);
  test.wall(false, 6.0f, 0.1f, 4.9f, 0, kHeight);  // its faces look into the rooms
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 4u) << story(found);
}

TEST(FindCells, ADoorwayInAWallOfAMetreIsADoor) {
  TestBuilding test;
  shell(test, 10, 5);
  test.wall(false, 5.0f, 0.1f, 4.9f, 0, kHeight, {{1.5f, 2.8f, 0, 2.1f}}, 1.1f);
  const Found found = find(test);
  ASSERT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  const auto doors = portalsOf(found, PortalKind::kDoor);
  ASSERT_EQ(doors.size(), 1u) << story(found);
  EXPECT_NEAR(widthOf(doors[0]), 1.3f, 0.1f);
  EXPECT_LT(std::abs(doors[0].center().x - 5.0f), 0.56f) << "within the wall";
}

TEST(FindCells, ADoorOverAGapInTheFloorKeepsItsRoom) {
  for (const float degrees : {0.0f, 8.0f, 17.0f, 33.0f}) {
    SCOPED_TRACE(degrees);
    TestBuilding test;
    test.turn(degrees * std::numbers::pi_v<float> / 180);
    test.slab(-6, -6, 11, 11, -0.6f);  // the ground, under the house too
    // The floor ends at the walls' inner faces, so that a gap of 0.2 m is left in the doorway.
    test.slab(0.1f, 0.1f, 4.9f, 4.9f, 0.0f);
    test.slab(-0.1f, -0.1f, 5.1f, 5.1f, kHeight + 0.2f);
    test.wall(true, 0.0f, -0.1f, 5.1f, -0.2f, kHeight);
    test.wall(true, 5.0f, -0.1f, 5.1f, -0.2f, kHeight);
    test.wall(false, 0.0f, 0.1f, 4.9f, -0.2f, kHeight, {{2.0f, 2.9f, -0.2f, 2.1f}});
    test.wall(false, 5.0f, 0.1f, 4.9f, -0.2f, kHeight);
    const Found found = find(test);
    ASSERT_EQ(found.cut.graph.cells.size(), 2u) << story(found);
    const auto doors = portalsOf(found, PortalKind::kDoor);
    ASSERT_EQ(doors.size(), 1u) << story(found);
    EXPECT_NEAR(widthOf(doors[0]), 0.9f, 0.1f);
    EXPECT_NEAR(doors[0].center().y, 1.05f, 0.25f);
  }
}

TEST(FindCells, RoomsThatTouchOnlyThroughTheOutsideAreJoinedByIt) {
  TestBuilding test;
  for (const float x : {0.0f, 8.0f}) {
    for (const float top : {0.0f, kHeight + 0.2f}) test.slab(x - 0.1f, -0.1f, x + 4.1f, 4.1f, top);
    for (const float z : {0.0f, 4.0f}) test.wall(true, z, x - 0.1f, x + 4.1f, 0, kHeight);
    const std::vector<TestBuilding::Hole> door{{1.5f, 2.4f, 0, 2.05f}};
    test.wall(false, x, 0.1f, 3.9f, 0, kHeight, x > 0 ? door : std::vector<TestBuilding::Hole>{});
    test.wall(false, x + 4, 0.1f, 3.9f, 0, kHeight,
              x > 0 ? std::vector<TestBuilding::Hole>{} : door);
  }
  test.slab(-4, -4, 16, 8, -0.2f);  // the ground
  const Found found = find(test);
  ASSERT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  ASSERT_EQ(found.cut.graph.portals.size(), 2u) << story(found);
  for (const Portal& door : found.cut.graph.portals) {
    EXPECT_EQ(door.kind, PortalKind::kDoor);
    EXPECT_EQ(std::min(door.front, door.back), kExterior);
  }
}

TEST(FindCells, AHoleBelowTheSmallestDoorIsNoDoor) {
  TestBuilding test;
  shell(test, 8, 5);
  test.wall(false, 4.0f, 0.1f, 4.9f, 0, kHeight, {{2.0f, 2.4f, 0.8f, 1.2f}});
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  ASSERT_EQ(found.cut.graph.portals.size(), 1u) << "one sees through it\n" << story(found);
  EXPECT_NE(found.cut.graph.portals[0].kind, PortalKind::kDoor);
}

TEST(FindCells, AClosetBelowTheSmallestRoomIsToldWithWhatWouldMakeItOne) {
  TestBuilding test;
  shell(test, 8, 5);
  test.wall(false, 1.1f, 0.1f, 1.2f, 0, kHeight, {{0.3f, 0.9f, 0, 2.0f}});
  test.wall(true, 1.1f, 0.1f, 1.2f, 0, kHeight);
  CellParameters parameters;
  const Found without = find(test, parameters);
  EXPECT_EQ(without.cut.graph.cells.size(), 2u) << story(without);
  const std::string log = story(without);
  const std::size_t at = log.find("--smallest-room ");
  ASSERT_NE(at, std::string::npos) << log;
  parameters.smallest_room = std::stof(log.substr(at + 16));
  EXPECT_LT(parameters.smallest_room, 1.0f);
  const Found with = find(test, parameters);
  EXPECT_EQ(with.cut.graph.cells.size(), 3u) << story(with);
}

TEST(FindCells, AFreeStandingCabinIsARoomAndAFreeStandingBlockIsNone) {
  TestBuilding test;
  shell(test, 10, 8);
  test.wall(true, 3.0f, 3.0f, 4.6f, 0, kHeight, {{3.4f, 4.2f, 0, 2.0f}}, 0.1f);
  test.wall(true, 4.6f, 3.0f, 4.6f, 0, kHeight, {}, 0.1f);
  test.wall(false, 3.0f, 3.05f, 4.55f, 0, kHeight, {}, 0.1f);
  test.wall(false, 4.6f, 3.05f, 4.55f, 0, kHeight, {}, 0.1f);
  test.box({6.5f, 0, 3.0f}, {8.3f, kHeight, 4.8f});
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  EXPECT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
}

TEST(FindCells, StoreysWithoutRoomsAreDropped) {
  TestBuilding test;
  shell(test, 8, 5);
  test.slab(-3, -3, 11, 8, 6.0f);  // a canopy over the roof
  const Found found = find(test);
  EXPECT_EQ(found.cut.graph.cells.size(), 2u) << story(found);
  EXPECT_EQ(found.cut.graph.storeys.size(), 1u);
  EXPECT_NEAR(found.cut.graph.storeys[0].floor_y, 0.0f, 0.02f);
}

TEST(FindCells, ACupboardNarrowerThanADoorIsToldWithWhatWouldMakeItOne) {
  TestBuilding test;
  shell(test, 8, 5);
  test.wall(false, 0.55f, 0.1f, 4.9f, 0, kHeight, {{2.0f, 2.8f, 0, 2.0f}}, 0.1f);
  CellParameters parameters;
  const std::string log = story(find(test, parameters));
  const std::size_t at = log.find("--smallest-door ");
  ASSERT_NE(at, std::string::npos) << log;
  EXPECT_EQ(log.find("--smallest-room "), std::string::npos) << log;
  parameters.smallest_door = std::stof(log.substr(at + 16));
  EXPECT_LT(parameters.smallest_door, 0.5f);
  const Found with = find(test, parameters);
  EXPECT_EQ(with.cut.graph.cells.size(), 3u) << story(with);
}

TEST(FindCells, ARoomWithANeckIsToldWithTheRatioThatPartsIt) {
  TestBuilding test;
  shell(test, 10, 5);
  test.wall(false, 5.0f, 0.1f, 1.0f, 0, kHeight);  // leaves 3 of 5 metres
  test.wall(false, 5.0f, 4.0f, 4.9f, 0, kHeight);
  CellParameters parameters;
  const Found one = find(test, parameters);
  EXPECT_EQ(one.cut.graph.cells.size(), 2u) << story(one);
  const std::string log = story(one);
  EXPECT_NE(log.find("narrows to 3.0 m at (5.1, 2.5)"), std::string::npos) << log;
  const std::size_t at = log.find("--merge-ratio ");
  ASSERT_NE(at, std::string::npos) << log;
  const float told = std::stof(log.substr(at + 14));
  parameters.merge_ratio = told;
  const Found two = find(test, parameters);
  EXPECT_EQ(two.cut.graph.cells.size(), 3u) << story(two);
  EXPECT_EQ(story(two).find("--merge-ratio "), std::string::npos);
  parameters.merge_ratio = told - 0.02f;
  EXPECT_EQ(find(test, parameters).cut.graph.cells.size(), 2u) << "no lower one does";
}

TEST(FindCells, AWindowInADoorIsPartOfTheDoor) {
  TestBuilding test;
  twoRooms(test);
  test.box({3.97f, 0, 2.0f}, {4.03f, 1.2f, 2.9f}, ObjectRole::kDoor);
  test.box({3.97f, 1.2f, 2.0f}, {4.03f, 2.05f, 2.2f}, ObjectRole::kDoor);
  test.box({3.97f, 1.2f, 2.7f}, {4.03f, 2.05f, 2.9f}, ObjectRole::kDoor);
  test.box({3.99f, 1.2f, 2.2f}, {4.01f, 2.05f, 2.7f}, ObjectRole::kFixed, true);
  const Found found = find(test);
  ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
  EXPECT_EQ(found.cut.graph.portals[0].kind, PortalKind::kDoor);
  EXPECT_NEAR(heightOf(found.cut.graph.portals[0]), 2.05f, 0.1f);
}

TEST(FindCells, AGarageDoorJoinsTheGarageToTheOutside) {
  TestBuilding test;
  shell(test, 7, 6, {{1.0f, 6.0f, 0, 2.2f}});
  const Found found = find(test);
  ASSERT_EQ(found.cut.graph.cells.size(), 2u) << story(found);
  ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
  EXPECT_NEAR(widthOf(found.cut.graph.portals[0]), 5.0f, 0.1f);
  EXPECT_NEAR(heightOf(found.cut.graph.portals[0]), 2.2f, 0.1f);
}

TEST(FindCells, ARoundRoomHasItsDoor) {
  TestBuilding test;
  shell(test, 10, 10);
  constexpr int kSides = 32;
  for (int i = 0; i < kSides; ++i) {
    test.turn(0);
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / kSides;
    test.turn(angle, {5, 0, 5});
    const float half = 3.0f * std::tan(std::numbers::pi_v<float> / kSides) + 0.02f;
    // Three of its sides are the doorway.
    const bool door = i >= 4 && i <= 6;
    test.box({7.9f, door ? 2.1f : 0.0f, 5 - half}, {8.1f, kHeight, 5 + half});
  }
  const Found found = find(test);
  ASSERT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
  const Portal& door = found.cut.graph.portals[0];
  EXPECT_EQ(door.kind, PortalKind::kDoor);
  EXPECT_NEAR(widthOf(door), 1.75f, 0.3f);
  EXPECT_NEAR(glm::distance(glm::vec2(door.center().x, door.center().z), glm::vec2(5, 5)), 3.0f,
              0.2f);
}

TEST(FindCells, ASpiralStairJoinsTwoStoreysOnce) {
  TestBuilding test;
  test.slab(-0.1f, -0.1f, 8.1f, 8.1f, 0.0f);
  test.slab(-0.1f, -0.1f, 8.1f, 8.1f, 6.0f);
  test.slab(-0.1f, -0.1f, 3.0f, 8.1f, 3.0f, 0.3f);
  test.slab(5.0f, -0.1f, 8.1f, 8.1f, 3.0f, 0.3f);
  test.slab(3.0f, -0.1f, 5.0f, 3.0f, 3.0f, 0.3f);
  test.slab(3.0f, 5.0f, 5.0f, 8.1f, 3.0f, 0.3f);
  for (const float z : {0.0f, 8.0f}) test.wall(true, z, -0.1f, 8.1f, 0, 5.8f);
  for (const float x : {0.0f, 8.0f}) test.wall(false, x, 0.1f, 7.9f, 0, 5.8f);
  for (int i = 0; i < 15; ++i) {
    test.turn(0.35f * float(i), {4, 0, 4});
    const float top = 0.2f * float(i + 1);
    test.box({4.1f, top - 0.05f, 3.8f}, {4.95f, top, 4.2f});
  }
  test.turn(0);
  test.box({3.92f, 0, 3.92f}, {4.08f, 4.0f, 4.08f});
  const Found found = find(test);
  ASSERT_EQ(found.cut.graph.cells.size(), 3u) << story(found);
  ASSERT_EQ(found.cut.graph.portals.size(), 1u) << story(found);
  const Portal& well = found.cut.graph.portals[0];
  EXPECT_EQ(well.kind, PortalKind::kOpening);
  EXPECT_GT(std::abs(well.plane.normal.y), 0.99f);
  EXPECT_NEAR(well.area(), 4.0f, 0.9f);
}

TEST(FindCells, EveryFreeVoxelThatCanBeReachedIsOwned) {
  TestBuilding test;
  twoStoreys(test);
  const Found found = find(test);
  const auto& grid = found.voxels;
  std::size_t beside = 0;
  for (int x = 1; x < grid.size.x; ++x)
    for (int z = 1; z < grid.size.z; ++z)
      for (int y = 1; y < grid.size.y; ++y) {
        const std::size_t here = grid.index(x, y, z);
        const bool solid = grid.bits[here] & kVoxelSolid;
        const bool owned = found.proposal.owner[here] != CellProposal::kNobody;
        EXPECT_FALSE(solid && owned);
        if (solid || owned) continue;
        for (const std::size_t other :
             {grid.index(x - 1, y, z), grid.index(x, y - 1, z), grid.index(x, y, z - 1)}) {
          beside += found.proposal.owner[other] != CellProposal::kNobody;
        }
      }
  EXPECT_EQ(beside, 0u) << "free voxels without an owner beside owned ones";
}

TEST(FindCells, GivesTheSameAnswerTwice) {
  TestBuilding test;
  test.turn(0.3f);
  twoRooms(test);
  const Found a = find(test), b = find(test);
  EXPECT_EQ(a.proposal.owner, b.proposal.owner);
  EXPECT_EQ(a.proposal.cell_names, b.proposal.cell_names);
  ASSERT_EQ(a.proposal.portals.size(), b.proposal.portals.size());
  for (std::size_t i = 0; i < a.proposal.portals.size(); ++i) {
    EXPECT_EQ(a.proposal.portals[i].name, b.proposal.portals[i].name);
    EXPECT_EQ(a.proposal.portals[i].polygon, b.proposal.portals[i].polygon);
  }
}

}  // namespace
}  // namespace enfilade
