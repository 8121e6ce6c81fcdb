#include "preprocess/claim_rooms.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "preprocess/cut_cells.h"
#include "tests/preprocess/authored_room.h"
#include "tests/preprocess/test_building.h"

namespace enfilade {
namespace {

AuthoredNames::Room emptyNode(const std::string& name, const glm::vec3& at) {
  AuthoredNames::Room result;
  result.name = name;
  result.position = at;
  return result;
}

CutCells cellsOf(const TestBuilding& test, const AuthoredNames& names) {
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  return cutCells(voxels, findCells(test.building, test.roles, voxels, {}, &names));
}

std::vector<std::string> namesOf(const CutCells& cells) {
  std::vector<std::string> names;
  for (const Cell& cell : cells.graph.cells) names.push_back(cell.name);
  return names;
}

std::string cellAt(const CutCells& cells, const glm::vec3& p) {
  return cells.graph.cells[locate(cells.graph, cells.grid, p).cell].name;
}

using Names = std::vector<std::string>;

TestBuilding twoRoomsAndADoor() {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.1f}});
  return test;
}

TEST(ClaimRooms, WhatNobodyNamesIsFound) {
  AuthoredNames names;
  names.rooms = {authoredRoom("kitchen", {4.3f, 0, 0.3f}, {7.6f, 2.5f, 3.8f})};  // rough
  const CutCells cells = cellsOf(twoRoomsAndADoor(), names);
  EXPECT_EQ(namesOf(cells), (Names{"exterior", "kitchen", "room-1"}));
  EXPECT_EQ(cellAt(cells, {7.8f, 2.8f, 3.8f}), "kitchen") << "beyond its bounds, in the same room";
  EXPECT_EQ(cellAt(cells, {1, 1, 1}), "room-1");
  ASSERT_EQ(cells.graph.portals.size(), 1u);
  EXPECT_EQ(cells.graph.portals[0].name, "door-kitchen-room-1");
  EXPECT_NEAR(cells.graph.portals[0].center().x, 4.0f, 0.03f);
}

TEST(ClaimRooms, AnEmptyNodeNamesTheRoomThatItStandsIn) {
  AuthoredNames names;
  names.rooms = {emptyNode("hall", {1, -0.02f, 3}), emptyNode("garden", {20, 0, 2}),
                 emptyNode("also hall", {3, 1, 3})};
  const CutCells cells = cellsOf(twoRoomsAndADoor(), names);
  EXPECT_EQ(namesOf(cells), (Names{"exterior", "hall", "room-1"}));
  EXPECT_EQ(cellAt(cells, {1, 1, 1}), "hall");
}

TEST(ClaimRooms, StoreysOfEmptyNodesHaveAFloor) {
  const TestBuilding test = twoRoomsAndADoor();
  AuthoredNames names;
  names.rooms = {emptyNode("hall", {1, 0.5f, 3})};
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const CellProposal named_only = authoredCells(names, voxels);
  ASSERT_EQ(named_only.storeys.size(), 1u);
  EXPECT_EQ(named_only.storeys[0].floor_y, 0.5f);
}

TEST(ClaimRooms, APortalOfTheAuthorStandsWhereHePutIt) {
  AuthoredNames names;
  names.rooms = {authoredRoom("west", {0, 0, 0}, {4, 3, 4})};
  AuthoredNames::NamedPortal door;
  door.portal.name = "west/east-portal";
  door.portal.polygon = {
      {3.93f, 0, 1.5f}, {3.93f, 2.1f, 1.5f}, {3.93f, 2.1f, 2.5f}, {3.93f, 0, 2.5f}};
  names.portals = {door};
  const CutCells cells = cellsOf(twoRoomsAndADoor(), names);
  EXPECT_EQ(namesOf(cells), (Names{"exterior", "west", "room-1"}));
  ASSERT_EQ(cells.graph.portals.size(), 1u);
  EXPECT_EQ(cells.graph.portals[0].polygon, door.portal.polygon);
}

TEST(ClaimRooms, ARoomOverTwoFoundOnesMakesThemOne) {
  AuthoredNames names;
  names.rooms = {authoredRoom("flat", {0, 0, 0}, {8, 3, 4})};
  const CutCells cells = cellsOf(twoRoomsAndADoor(), names);
  EXPECT_EQ(namesOf(cells), (Names{"exterior", "flat"}));
  EXPECT_EQ(cellAt(cells, {1, 1, 1}), "flat");
  EXPECT_EQ(cellAt(cells, {7, 1, 1}), "flat");
}

TEST(ClaimRooms, TwoRoomsInAnOpenOneAreParted) {
  TestBuilding test;
  test.twoRooms({{0, 4, 0, 3}});  // nothing between them
  AuthoredNames names;
  EXPECT_EQ(namesOf(cellsOf(test, names)), (Names{"exterior", "room-1"}));
  names.rooms = {authoredRoom("living", {0, 0, 0}, {5, 3, 4}),
                 authoredRoom("dining", {5, 0, 0}, {8, 3, 4})};
  const CutCells cells = cellsOf(test, names);
  EXPECT_EQ(namesOf(cells), (Names{"exterior", "living", "dining"}));
  ASSERT_EQ(cells.graph.portals.size(), 1u);
  EXPECT_NEAR(cells.graph.portals[0].center().x, 5.0f, 0.06f);
  EXPECT_NEAR(cells.graph.portals[0].area(), 11.4f, 0.3f);
}

TEST(ClaimRooms, AClosetTooSmallToBeFoundIsARoomIfNamed) {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.1f}});
  test.wall(false, 0.9f, 0, 1, 0, 3);
  test.wall(true, 1, 0, 0.9f, 0, 3, {{0.2f, 0.8f, 0, 2.0f}});
  AuthoredNames names;
  EXPECT_EQ(namesOf(cellsOf(test, names)), (Names{"exterior", "room-1", "room-2"}));
  names.rooms = {authoredRoom("closet", {0.1f, 0, 0.1f}, {0.8f, 3, 0.9f})};
  const CutCells cells = cellsOf(test, names);
  EXPECT_EQ(namesOf(cells), (Names{"exterior", "closet", "room-1", "room-2"}));
  EXPECT_EQ(cells.graph.portals.size(), 2u);
}

}  // namespace
}  // namespace enfilade
