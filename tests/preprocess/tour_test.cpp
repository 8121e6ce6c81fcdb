#include "preprocess/tour.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "preprocess/tour_check.h"
#include "scene/error.h"
#include "tour_houses.h"
#include "tour_oracles.h"

namespace enfilade {
namespace {

using testing::expectWalked;
using testing::HouseBuilder;
using testing::lengthOf;
using testing::longestStep;
using testing::noted;
using testing::sharpestTurn;
using testing::twoRooms;

std::vector<CellId> cells(std::initializer_list<CellId> list) { return list; }

// 120° a second at 30 frames a second.
constexpr float kComfortableTurn = 0.0698f;

TEST(Tour, WalksThroughTheDoorwayBetweenTwoRooms) {
  const House house = twoRooms(0.9f).build();
  const Tour tour = makeTour(house, {.frames = 520});
  expectWalked(house, tour, 520);
  EXPECT_EQ(tour.visited, cells({1, 2}));
  EXPECT_TRUE(noted(tour, {"not reached", "exterior"}));
  EXPECT_LT(lengthOf(tour), 8.0f);
}

TEST(Tour, GoesWellInsideEachRoom) {
  const House house = twoRooms(0.9f).build();
  const Tour tour = makeTour(house, {.frames = 520});
  float left = 9;
  float right = 0;
  for (const TimedPose& pose : tour.path.poses) {
    left = std::min(left, pose.pose.position.x);
    right = std::max(right, pose.pose.position.x);
  }
  EXPECT_LT(left, 3.0f);
  EXPECT_GT(right, 5.2f);
}

TEST(Tour, MovesAndTurnsSmoothlyGivenEnoughFrames) {
  const House house = twoRooms(0.9f).build();
  const Tour tour = makeTour(house, {.frames = 520});
  EXPECT_LT(longestStep(tour), 0.06f);
  EXPECT_LT(sharpestTurn(tour), kComfortableTurn);
}

TEST(Tour, IsTheSameEveryTime) {
  const House house = twoRooms(0.9f).build();
  const Tour a = makeTour(house, {.frames = 100});
  const Tour b = makeTour(house, {.frames = 100});
  ASSERT_EQ(a.path.poses.size(), b.path.poses.size());
  for (std::size_t i = 0; i < a.path.poses.size(); ++i) {
    EXPECT_EQ(a.path.poses[i].pose.position, b.path.poses[i].pose.position);
    EXPECT_EQ(a.path.poses[i].pose.world_from_camera_rotation,
              b.path.poses[i].pose.world_from_camera_rotation);
  }
  EXPECT_EQ(a.notes, b.notes);
}

TEST(Tour, PassesADoorwayOf65Centimetres) {
  const House house = twoRooms(0.65f).build();
  const Tour tour = makeTour(house, {.frames = 300});
  expectWalked(house, tour, 300);
  EXPECT_EQ(tour.visited, cells({1, 2}));
}

TEST(Tour, SqueezesThroughANarrowDoorwayAndSaysSo) {
  const House house = twoRooms(0.38f).build();
  const Tour tour = makeTour(house, {.frames = 300});
  expectWalked(house, tour, 300);
  EXPECT_EQ(tour.visited, cells({1, 2}));
  EXPECT_TRUE(noted(tour, {"narrow:"}));
}

TEST(Tour, SaysThatADoorwayIsTooNarrow) {
  const House house = twoRooms(0.2f).build();
  const Tour tour = makeTour(house, {.frames = 100});
  expectWalked(house, tour, 100);
  EXPECT_EQ(tour.visited.size(), 1u);
  EXPECT_TRUE(noted(tour, {"not reached", "the way in is narrower"}));
}

TEST(Tour, DoorsAreOpenAndWallsAreNot) {
  HouseBuilder with_door = twoRooms(0.9f);
  with_door.solid({4.08f, 0, 1.55f}, {4.12f, 2.1f, 2.45f}, ObjectRole::kDoor);
  EXPECT_EQ(makeTour(with_door.build(), {.frames = 100}).visited, cells({1, 2}));
  HouseBuilder with_board = twoRooms(0.9f);
  with_board.solid({4.08f, 0, 1.55f}, {4.12f, 2.1f, 2.45f});
  EXPECT_EQ(makeTour(with_board.build(), {.frames = 100}).visited.size(), 1u);
}

TEST(Tour, ClimbsALowSillButNotAHighOne) {
  HouseBuilder low = twoRooms(0.9f, 2.5f);
  low.solid({4, 0, 1.55f}, {4.2f, 0.3f, 2.45f});
  EXPECT_EQ(makeTour(low.build(), {.frames = 100}).visited, cells({1, 2}));
  HouseBuilder high = twoRooms(0.9f, 2.5f);
  high.solid({4, 0, 1.55f}, {4.2f, 0.5f, 2.45f});
  const Tour tour = makeTour(high.build(), {.frames = 100});
  EXPECT_EQ(tour.visited.size(), 1u);
  EXPECT_TRUE(noted(tour, {"not reached", "a step higher than 0.35 m"}));
}

TEST(Tour, StepsOverAGapInTheFloorOfADoorway) {
  HouseBuilder b;
  b.solid({-0.2f, -0.2f, -0.2f}, {4, 0, 4.2f});
  b.solid({4.2f, -0.2f, -0.2f}, {8.4f, 0, 4.2f});
  b.wallWithHole({4, 0, 0}, {4.2f, 2.6f, 4}, 1.55f, 2.45f, 0, 2.1f);
  const CellId left = b.cell("left", {0, 0, 0}, {4, 2.6f, 4});
  const CellId right = b.cell("right", {4.2f, 0, 0}, {8.2f, 2.6f, 4});
  b.portal(right, left, PortalKind::kDoor, {4.1f, 0, 1.55f}, {4.1f, 2.1f, 2.45f});
  const Tour tour = makeTour(b.build(), {.frames = 100});
  EXPECT_TRUE(std::includes(tour.visited.begin(), tour.visited.end(), &left, &left + 1));
  EXPECT_TRUE(std::includes(tour.visited.begin(), tour.visited.end(), &right, &right + 1));
}

TEST(Tour, GoesAroundFurniture) {
  HouseBuilder b = twoRooms(0.9f);
  b.solid({1.2f, 0.7f, 1.0f}, {2.8f, 0.75f, 3.0f});  // a table top
  b.solid({4.9f, 0, 1.2f}, {5.7f, 1.1f, 2.8f});      // a cupboard before the door
  const House house = b.build();
  const Tour tour = makeTour(house, {.frames = 400});
  expectWalked(house, tour, 400);
  EXPECT_EQ(tour.visited, cells({1, 2}));
  for (const TimedPose& pose : tour.path.poses) {
    const glm::vec3 p = pose.pose.position;
    EXPECT_FALSE(p.x > 1.2f && p.x < 2.8f && p.z > 1.0f && p.z < 3.0f);
    EXPECT_FALSE(p.x > 4.9f && p.x < 5.7f && p.z > 1.2f && p.z < 2.8f);
  }
}

TEST(Tour, RejectsNonsense) {
  const House house = twoRooms(0.9f).build();
  EXPECT_THROW(makeTour(house, {.frames = 1}), Error);
  EXPECT_THROW(makeTour(house, {.frames = 10, .body_radius = 0}), Error);
  EXPECT_THROW(makeTour(House{}, {}), Error);
}

TEST(Tour, SaysThatThereIsNowhereToStand) {
  HouseBuilder b;
  b.cell("shaft", {0, 0, 0}, {2, 2, 2});
  b.triangle({0, 0, 0}, {0, 2, 0}, {0.1f, 1, 2});  // nearly upright: nothing to stand on
  b.triangle({1, 0, 0}, {1, 2, 0}, {1.0f, 1, 0.01f});
  try {
    makeTour(b.build(), {.frames = 10, .body_radius = 0.2f});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
  }
}

TEST(TourCheck, FindsAWalkThroughAWall) {
  const House house = twoRooms(0.9f).build();
  CameraPath path;
  path.poses = {{0, {{2, 1.6f, 1}}}, {1, {{6, 1.6f, 1}}}};
  EXPECT_FALSE(checkTour(house, path).empty());
  path.poses = {{0, {{2, 1.6f, 2}}}, {1, {{6, 1.6f, 2}}}};
  EXPECT_TRUE(checkTour(house, path).empty());
  path.poses = {{0, {{2, 1.6f, 2}}}, {1, {{3.9f, 1.6f, 1}}}};
  EXPECT_EQ(checkTour(house, path).size(), 1u);
}

}  // namespace
}  // namespace enfilade
