#include <gtest/gtest.h>

#include <algorithm>

#include "preprocess/tour.h"
#include "tour_houses.h"
#include "tour_oracles.h"

namespace enfilade {
namespace {

using testing::expectWalked;
using testing::HouseBuilder;
using testing::noted;
using testing::twoRooms;

constexpr float kComfortableTurn = 0.0698f;  // 120° a second at 30 frames a second

std::vector<CellId> cells(std::initializer_list<CellId> list) { return list; }

// Four rooms of 3 × 3 m about a cross of walls, a door in each of its arms.
HouseBuilder ringOfRooms() {
  HouseBuilder b;
  b.slabs({-0.2f, 0, -0.2f}, {6.4f, 2.6f, 6.4f});
  b.solid({-0.2f, 0, -0.2f}, {0, 2.6f, 6.4f});
  b.solid({6.2f, 0, -0.2f}, {6.4f, 2.6f, 6.4f});
  b.solid({0, 0, -0.2f}, {6.2f, 2.6f, 0});
  b.solid({0, 0, 6.2f}, {6.2f, 2.6f, 6.4f});
  b.wallWithHole({3, 0, 0}, {3.2f, 2.6f, 3}, 1, 1.9f, 0, 2.1f);
  b.wallWithHole({3, 0, 3}, {3.2f, 2.6f, 6.2f}, 4.3f, 5.2f, 0, 2.1f);
  for (const float x : {0.0f, 3.2f}) {
    b.solid({x, 0, 3}, {x + 1, 2.6f, 3.2f});
    b.solid({x + 1.9f, 0, 3}, {x + 3, 2.6f, 3.2f});
    b.solid({x + 1, 2.1f, 3}, {x + 1.9f, 2.6f, 3.2f});
  }
  const CellId sw = b.cell("sw", {0, 0, 0}, {3, 2.6f, 3});
  const CellId se = b.cell("se", {3.2f, 0, 0}, {6.2f, 2.6f, 3});
  const CellId nw = b.cell("nw", {0, 0, 3.2f}, {3, 2.6f, 6.2f});
  const CellId ne = b.cell("ne", {3.2f, 0, 3.2f}, {6.2f, 2.6f, 6.2f});
  b.portal(se, sw, PortalKind::kDoor, {3.1f, 0, 1}, {3.1f, 2.1f, 1.9f});
  b.portal(ne, nw, PortalKind::kDoor, {3.1f, 0, 4.3f}, {3.1f, 2.1f, 5.2f});
  b.portal(nw, sw, PortalKind::kDoor, {1, 0, 3.1f}, {1.9f, 2.1f, 3.1f});
  b.portal(ne, se, PortalKind::kDoor, {4.2f, 0, 3.1f}, {5.1f, 2.1f, 3.1f});
  return b;
}

// Two rooms of 7 × 4 m above each other, a stair of 16 risers along the wall z = 0.
HouseBuilder twoStoreys() {
  HouseBuilder b;
  b.solid({-0.2f, -0.2f, -0.2f}, {7.2f, 0, 4.2f});
  b.solid({-0.2f, 5.4f, -0.2f}, {7.2f, 5.6f, 4.2f});
  b.solid({-0.2f, 0, -0.2f}, {0, 5.4f, 4.2f});
  b.solid({7, 0, -0.2f}, {7.2f, 5.4f, 4.2f});
  b.solid({0, 0, -0.2f}, {7, 5.4f, 0});
  b.solid({0, 0, 4}, {7, 5.4f, 4.2f});
  b.solid({0, 2.6f, 1}, {7, 2.8f, 4});
  b.solid({0, 2.6f, 0}, {1.9f, 2.8f, 1});
  b.solid({5.05f, 2.6f, 0}, {7, 2.8f, 1});
  for (int i = 0; i < 15; ++i) {
    const auto step = static_cast<float>(i);
    b.solid({1 + 0.27f * step, 0, 0}, {1.27f + 0.27f * step, 0.175f * (step + 1), 1});
  }
  b.solid({1.85f, 2.8f, 1}, {5.05f, 3.8f, 1.05f});  // railings
  b.solid({1.85f, 2.8f, 0}, {1.9f, 3.8f, 1});
  const CellId below = b.cell("below", {0, 0, 0}, {7, 2.6f, 4});
  const CellId above = b.cell("above", {0, 2.8f, 0}, {7, 5.4f, 4});
  b.portal(above, below, PortalKind::kOpening, {1.9f, 2.7f, 0}, {5.05f, 2.7f, 1});
  return b;
}

// A room of 4 × 4 m on a lawn, its door in the wall x = 0.
HouseBuilder cottage() {
  HouseBuilder b;
  b.solid({-10, -0.3f, -8}, {12, -0.1f, 12});
  b.slabs({-0.2f, 0, -0.2f}, {4.2f, 2.6f, 4.2f});
  b.wallWithHole({-0.2f, 0, -0.2f}, {0, 2.6f, 4.2f}, 1.5f, 2.4f, 0, 2.1f);
  b.solid({4, 0, -0.2f}, {4.2f, 2.6f, 4.2f});
  b.solid({0, 0, -0.2f}, {4, 2.6f, 0});
  b.solid({0, 0, 4}, {4, 2.6f, 4.2f});
  const CellId room = b.cell("room", {0, 0, 0}, {4, 2.6f, 4});
  b.portal(room, kExterior, PortalKind::kDoor, {-0.1f, 0, 1.5f}, {-0.1f, 2.1f, 2.4f});
  return b;
}

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
