#include "preprocess/object_roles.h"

#include <gtest/gtest.h>

#include "preprocess/authored_names.h"
#include "test_building.h"

namespace enfilade {
namespace {

TEST(ObjectRoles, UsualNamesOfDoorsAndWindowsAreKnown) {
  TestBuilding test;
  const std::vector<std::pair<const char*, ObjectRole>> names{
      {"IfcDoor/Single-Flush/1x2", ObjectRole::kDoor},
      {"Door", ObjectRole::kDoor},
      {"door.001", ObjectRole::kDoor},
      {"Door_12", ObjectRole::kDoor},
      {"Door#3", ObjectRole::kDoor},
      {"Door/7", ObjectRole::kDoor},
      {"IfcWindow/Fixed/3", ObjectRole::kGlass},
      {"Window.014", ObjectRole::kGlass},
      {"doorstep-1", ObjectRole::kFixed},
      {"Door_frame", ObjectRole::kFixed},
      {"Windowsill", ObjectRole::kFixed},
      {"Outdoor bench", ObjectRole::kFixed}};
  for (std::size_t i = 0; i < names.size(); ++i) {
    test.box({0, 0, 0}, {1, 1, 1});
    test.building.nodes[i].name = names[i].first;
  }
  const auto roles = namedRoles(test.building, kUsualDoors, kUsualWindows);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_EQ(roles[i], names[i].second) << names[i].first;
  }
}

TEST(ObjectRoles, WhatIsCalledADoorButStandsInNoPortalIsDrawn) {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.0f}});
  test.box({3.97f, 0, 1.5f}, {4.03f, 2.0f, 2.5f}, ObjectRole::kDoor);
  const std::size_t leaf = test.roles.size() - 1;
  test.box({1.0f, 0, 0.3f}, {1.5f, 1.8f, 0.34f}, ObjectRole::kDoor);  // a cupboard's
  CutCells cells;
  Portal portal;
  portal.polygon = {{4, 0, 1.5f}, {4, 0, 2.5f}, {4, 2, 2.5f}, {4, 2, 1.5f}};
  cells.graph.portals = {portal};
  fixDoorsWithoutPortals(test.building, cells, test.roles);
  EXPECT_EQ(test.roles[leaf], ObjectRole::kDoor);
  EXPECT_EQ(test.roles[leaf + 1], ObjectRole::kFixed);
  ASSERT_EQ(cells.log.size(), 1u);
  EXPECT_EQ(cells.log[0].rfind("1 objects", 0), 0u) << cells.log[0];
}

}  // namespace
}  // namespace enfilade
