#include "preprocess/authored_diagnosis.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/preprocess/authored_room.h"
#include "tests/preprocess/test_building.h"

namespace enfilade {
namespace {

AuthoredNames::NamedPortal doorway(bool towards_west) {
  AuthoredNames::NamedPortal door;
  door.portal.name = "west/door";
  door.portal.polygon = {{4, 0, 1.5f}, {4, 2, 1.5f}, {4, 2, 2.5f}, {4, 0, 2.5f}};
  if (towards_west) std::reverse(door.portal.polygon.begin(), door.portal.polygon.end());
  door.portal.kind = PortalKind::kDoor;
  door.from = "west";
  door.to = "east";
  return door;
}

std::vector<std::string> logOf(const AuthoredNames& names) {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.0f}});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  CutCells cells = cutCells(voxels, authoredCells(names, voxels));
  cells.log.clear();
  diagnoseAuthored(names, voxels, cells);
  return cells.log;
}

bool tells(const std::vector<std::string>& log, const std::string& text) {
  return std::any_of(log.begin(), log.end(),
                     [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

TEST(AuthoredDiagnosis, SaysNothingOfWhatIsRight) {
  AuthoredNames names;
  names.rooms = {authoredRoom("west", {0, 0, 0}, {4, 3, 4}),
                 authoredRoom("east", {4, 0, 0}, {8, 3, 4})};
  names.portals = {doorway(true)};
  for (const std::string& line : logOf(names)) ADD_FAILURE() << line;
}

TEST(AuthoredDiagnosis, TellsOverlapsButNotRoomsWithinRooms) {
  AuthoredNames names;
  names.rooms = {authoredRoom("west", {0, 0, 0}, {6, 3, 4}),
                 authoredRoom("east", {4, 0, 0}, {8, 3, 4})};
  names.portals = {doorway(true)};
  EXPECT_TRUE(tells(logOf(names), "west and east overlap by"));
  names.rooms[0] = authoredRoom("west", {0, 0, 0}, {8, 3, 4});
  EXPECT_FALSE(tells(logOf(names), "overlap"));
}

TEST(AuthoredDiagnosis, TellsRoomsThatNothingLeadsToAndPortalsThatFaceAway) {
  AuthoredNames names;
  names.rooms = {authoredRoom("west", {0, 0, 0}, {4, 3, 4}),
                 authoredRoom("east", {4, 0, 0}, {8, 3, 4})};
  const auto alone = logOf(names);
  EXPECT_TRUE(tells(alone, "no portal leads to east") || tells(alone, "east is no cell"));
  for (const bool towards_west : {true, false}) {
    names.portals = {doorway(towards_west)};
    names.portals[0].portal.two_way = false;
    EXPECT_EQ(tells(logOf(names), "faces away from west"), !towards_west) << towards_west;
  }
  names.portals[0].to = "cellar";
  EXPECT_TRUE(tells(logOf(names), "is said to join west and cellar; it joins"));
}

}  // namespace
}  // namespace enfilade
