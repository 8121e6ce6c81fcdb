#include "tour_buildings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "preprocess/tour.h"
#include "tour_oracles.h"

namespace enfilade {
namespace {

using testing::cottage;
using testing::expectWalked;
using testing::HouseBuilder;
using testing::noted;
using testing::ringOfRooms;
using testing::twoRooms;
using testing::twoStoreys;

constexpr float kComfortableTurn = 0.0698f;  // 120° a second at 30 frames a second

std::vector<CellId> cells(std::initializer_list<CellId> list) { return list; }

TEST(TourBuildings, VisitsARingOfRoomsWithoutWalkingItTwice) {
  const House house = ringOfRooms().build();
  const Tour tour = makeTour(house, {.frames = 520});
  expectWalked(house, tour, 520);
  EXPECT_EQ(tour.visited, cells({1, 2, 3, 4}));
  EXPECT_LT(testing::lengthOf(tour), 14.0f);
  EXPECT_LT(testing::sharpestTurn(tour), kComfortableTurn);
}

TEST(TourBuildings, FewFramesStillVisitEveryRoomAndCrossNoWall) {
  const House house = ringOfRooms().build();
  const Tour tour = makeTour(house, {.frames = 16});
  expectWalked(house, tour, 16);
  EXPECT_EQ(tour.visited, cells({1, 2, 3, 4}));
}

TEST(TourBuildings, TwoFramesAreTwoFrames) {
  EXPECT_EQ(makeTour(ringOfRooms().build(), {.frames = 2}).path.poses.size(), 2u);
}

TEST(TourBuildings, ClimbsStairsSmoothly) {
  const House house = twoStoreys().build();
  const Tour tour = makeTour(house, {.frames = 520});
  expectWalked(house, tour, 520);
  EXPECT_EQ(tour.visited, cells({1, 2}));
  float lowest = 9;
  float highest = 0;
  const auto& poses = tour.path.poses;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const float y = poses[i].pose.position.y;
    lowest = std::min(lowest, y);
    highest = std::max(highest, y);
    if (i == 0) continue;
    const glm::vec3 step = poses[i].pose.position - poses[i - 1].pose.position;
    EXPECT_LE(std::abs(step.y), 0.9f * glm::length(glm::vec2(step.x, step.z)) + 1e-4f) << i;
  }
  EXPECT_NEAR(lowest, 1.6f, 0.02f);
  EXPECT_NEAR(highest, 4.4f, 0.02f);
}

TEST(TourBuildings, SaysThatOnlyAWindowLeadsToARoom) {
  HouseBuilder b = twoRooms(0.9f);
  b.slabs({8.4f, 0, -0.2f}, {12.6f, 2.6f, 4.2f});
  b.wallWithHole({12.4f, 0, -0.2f}, {12.6f, 2.6f, 4.2f}, 1, 3, 1, 2);
  b.solid({8.4f, 0, -0.2f}, {12.4f, 2.6f, 0});
  b.solid({8.4f, 0, 4}, {12.4f, 2.6f, 4.2f});
  const CellId closed = b.cell("closed", {8.4f, 0, 0}, {12.4f, 2.6f, 4});
  b.portal(kExterior, closed, PortalKind::kWindow, {12.5f, 1, 1}, {12.5f, 2, 3});
  const House house = b.build();
  const Tour tour = makeTour(house, {.frames = 200});
  expectWalked(house, tour, 200);
  EXPECT_EQ(tour.visited, cells({1, 2}));
  EXPECT_TRUE(noted(tour, {"not reached: closed", "only windows"}));
}

TEST(TourBuildings, StartsAShortStepOutsideTheDoorAndWalksIn) {
  const House house = cottage().build();
  const Tour tour = makeTour(house, {.frames = 300});
  expectWalked(house, tour, 300);
  EXPECT_EQ(tour.visited, cells({0, 1}));
  const Pose& first = tour.path.poses.front().pose;
  EXPECT_LT(first.position.x, -1.0f);
  EXPECT_GT(first.position.x, -3.5f);
  EXPECT_NEAR(first.position.z, 1.95f, 0.8f);
  EXPECT_GT((first.world_from_camera_rotation * glm::vec3(0, 0, -1)).x, 0.7f);
  for (const TimedPose& pose : tour.path.poses) {
    EXPECT_GT(pose.pose.position.x, -3.5f) << "a lap around the lawn";
  }
}

TEST(TourBuildings, ARoomWithoutAFloorIsNotReachedAndSaysWhy) {
  HouseBuilder b = twoRooms(0.9f);
  b.cell("void", {20, 0, 0}, {22, 3, 2});
  b.triangle({20, 3, 0}, {22, 3, 0}, {22, 3, 2});
  const Tour tour = makeTour(b.build(), {.frames = 100});
  EXPECT_TRUE(noted(tour, {"not reached: void", "no floor"}));
}

}  // namespace
}  // namespace enfilade
