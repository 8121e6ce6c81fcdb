// Which images a frame wants in memory.
#include "app/wanted_sides.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/preprocess/tour_houses.h"

namespace enfilade {
namespace {

/// Three rooms in a row along x, doorways at x = 4 and x = 8; portal 0 and 1, cells 1, 2 and 3.
House threeRooms() {
  testing::HouseBuilder builder;
  builder.slabs({0, 0, 0}, {12, 2.6f, 4});
  const CellId a = builder.cell("a", {0, 0, 0}, {4, 2.6f, 4});
  const CellId b = builder.cell("b", {4, 0, 0}, {8, 2.6f, 4});
  const CellId c = builder.cell("c", {8, 0, 0}, {12, 2.6f, 4});
  builder.portal(b, a, PortalKind::kDoor, {4, 0, 1.5f}, {4, 2.1f, 2.5f});
  builder.portal(c, b, PortalKind::kDoor, {8, 0, 1.5f}, {8, 2.1f, 2.5f});
  return builder.build();
}

/// What an eye in room a wants that looks along x, or back.
WantedSides wantedFrom(const House& house, const glm::vec3& eye, float ahead) {
  Camera camera;
  camera.pose = lookAt(eye, eye + glm::vec3(ahead, 0, 0));
  const VisibleSet set = cullByPortals(house.graph, camera.view(), 1);
  WantedSides wanted;
  findWantedSides(house, set, eye, wanted);
  return wanted;
}

TEST(WantedSides, ThoseInViewComeFirstTheNearestBeforeAll) {
  const House house = threeRooms();
  const WantedSides wanted = wantedFrom(house, {1, 1.6f, 2}, 1);
  ASSERT_EQ(wanted.in_view, 2u);
  EXPECT_EQ(wanted.sides[0], sideIndex(0, false)) << "as seen from room a";
  EXPECT_EQ(wanted.sides[1], sideIndex(1, false));
}

TEST(WantedSides, WhatATurnOrAStepBringsIntoViewIsAmongThem) {
  const House house = threeRooms();
  const WantedSides wanted = wantedFrom(house, {1, 1.6f, 2}, -1);
  EXPECT_EQ(wanted.in_view, 0u);
  // Its own doorway first, then that of the next room, from within; not those two rooms on.
  ASSERT_EQ(wanted.sides.size(), 3u);
  EXPECT_EQ(wanted.sides[0] / 2, 0u);
  EXPECT_EQ(wanted.sides[1] / 2, 0u);
  EXPECT_EQ(wanted.sides[2], sideIndex(1, false));
}

TEST(WantedSides, NoSideIsListedTwice) {
  const House house = threeRooms();
  for (const float ahead : {1.0f, -1.0f}) {
    std::vector<std::size_t> sides = wantedFrom(house, {2, 1.6f, 2}, ahead).sides;
    std::sort(sides.begin(), sides.end());
    EXPECT_EQ(std::unique(sides.begin(), sides.end()), sides.end());
  }
}

TEST(WantedSides, APortalNearerThanTheSwitchDistanceIsNotCountedAsInView) {
  const House house = threeRooms();
  const WantedSides wanted = wantedFrom(house, {4 - 0.5f * house.switch_distance, 1.6f, 2}, 1);
  EXPECT_EQ(wanted.in_view, 1u);
  EXPECT_EQ(wanted.sides[0], sideIndex(1, false));
  EXPECT_NE(std::find(wanted.sides.begin(), wanted.sides.end(), sideIndex(0, false)),
            wanted.sides.end())
      << "it will be when one steps back";
}

}  // namespace
}  // namespace enfilade
