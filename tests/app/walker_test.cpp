#include "app/walker.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>
#include <thread>

#include "tests/preprocess/tour_buildings.h"
#include "tests/preprocess/tour_oracles.h"

namespace enfilade {
namespace {

using testing::cottage;
using testing::HouseBuilder;
using testing::twoRooms;
using testing::twoStoreys;

constexpr float kFrame = 1.0f / 60;
constexpr float kToPlusX = -0.5f * glm::pi<float>();  // yaw
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr Stride kForward{.forward = 1};

void walkFor(Walker& walker, const Stride& stride, float seconds) {
  for (float t = 0; t < seconds - 1e-4f; t += kFrame) walker.step(stride, kFrame);
}

Walker walkerAt(const House& house, const glm::vec3& eye, float yaw) {
  Walker walker(house);
  walker.place(eye);
  walker.look(yaw, 0);
  return walker;
}

/// One room of 20 × 4 m.
HouseBuilder hall() {
  HouseBuilder b;
  b.slabs({-0.2f, 0, -0.2f}, {20.2f, 2.6f, 4.2f});
  b.solid({-0.2f, 0, -0.2f}, {0, 2.6f, 4.2f});
  b.solid({20, 0, -0.2f}, {20.2f, 2.6f, 4.2f});
  b.solid({0, 0, -0.2f}, {20, 2.6f, 0});
  b.solid({0, 0, 4}, {20, 2.6f, 4.2f});
  b.cell("hall", {0, 0, 0}, {20, 2.6f, 4});
  return b;
}

TEST(Walker, StandsAtEyeHeightFromTheStart) {
  const House house = twoRooms(0.9f).build();
  const Walker walker(house);
  EXPECT_FALSE(walker.flying());
  EXPECT_NEAR(walker.eye().y, 1.6f, 1e-3f);
  EXPECT_NEAR(walker.floorHeight(), 0.0f, 1e-3f);
  EXPECT_EQ(walker.velocity(), glm::vec3(0));
}

TEST(Walker, IsAtFullSpeedWithinATenthOfASecondOrSoAndStopsAsSoon) {
  const House house = hall().build();
  Walker walker = walkerAt(house, {2, 1.6f, 2}, kToPlusX);
  walkFor(walker, kForward, 0.15f);
  EXPECT_GT(walker.velocity().x, 0.95f * walker.gait().speed);
  const float before = walker.eye().x;
  walkFor(walker, kForward, 1);
  EXPECT_NEAR(walker.eye().x - before, walker.gait().speed, 0.05f);
  walkFor(walker, {}, 0.3f);
  const float stopped = walker.eye().x;
  EXPECT_LT(stopped - before, walker.gait().speed + 0.1f);
  walkFor(walker, {}, 1);
  EXPECT_EQ(walker.eye().x, stopped);
  EXPECT_EQ(walker.velocity(), glm::vec3(0));
}

TEST(Walker, IsNoFasterAlongADiagonal) {
  const House house = hall().build();
  Walker walker = walkerAt(house, {2, 1.6f, 2}, kToPlusX + 0.25f * glm::pi<float>());
  walkFor(walker, {.forward = 1, .right = 1}, 2);
  EXPECT_NEAR(walker.eye().x - 2.0f, 2 * walker.gait().speed, 0.15f);
}

TEST(Walker, GoesTheSameWayHoweverTheTimeIsCutUp) {
  HouseBuilder b = twoRooms(0.9f);
  b.solid({2, 0, 1.2f}, {2.5f, 1, 1.8f});
  const House house = b.build();
  for (const float yaw : {kToPlusX, kToPlusX + 0.3f, kToPlusX - 0.5f, 2.0f}) {
    Walker fine = walkerAt(house, {1, 1.6f, 1.7f}, yaw);
    Walker coarse = walkerAt(house, {1, 1.6f, 1.7f}, yaw);
    for (int i = 0; i < 8; ++i) {
      for (int k = 0; k < 30; ++k) fine.step(kForward, kFrame);
      coarse.step(kForward, 0.5f);
      EXPECT_LT(glm::length(fine.eye() - coarse.eye()), 0.02f) << "yaw " << yaw << " step " << i;
    }
  }
}

TEST(Walker, NoSpeedTakesItThroughAWall) {
  const House house = twoRooms(0.9f).build();
  Walker walker = walkerAt(house, {2, 1.6f, 3.4f}, kToPlusX);
  walker.setGait({.speed = 50});
  for (int i = 0; i < 5; ++i) walker.step(kForward, 1);
  EXPECT_LT(walker.eye().x, 3.95f);
  EXPECT_GT(walker.eye().x, 3.6f);
}

TEST(Walker, PressedAgainstAWallItComesToRest) {
  const House house = twoRooms(0.9f).build();
  for (const float yaw : {kToPlusX, kToPlusX + 0.2f, 0.1f, 0.25f * glm::pi<float>()}) {
    Walker walker = walkerAt(house, {2, 1.6f, 1}, yaw);
    walkFor(walker, kForward, 40);  // into a corner, at some angles
    const glm::vec3 rest = walker.eye();
    for (int i = 0; i < 60; ++i) {
      walker.step(kForward, kFrame);
      EXPECT_LT(glm::length(walker.eye() - rest), 0.012f) << "yaw " << yaw;
    }
    EXPECT_GT(testing::bruteDistance(house, walker.eye()), 0.1);
  }
}

TEST(Walker, SlidesEvenlyAlongAWall) {
  const House house = hall().build();
  Walker walker = walkerAt(house, {2, 1.6f, 0.4f}, kToPlusX + 0.5f);
  walkFor(walker, kForward, 1);
  const float least_way = 0.8f * std::cos(0.5f) * walker.gait().speed * kFrame;
  for (int i = 0; i < 300; ++i) {
    const glm::vec3 before = walker.eye();
    walker.step(kForward, kFrame);
    EXPECT_GT(walker.eye().x - before.x, least_way) << i;
    EXPECT_LT(std::abs(walker.eye().z - before.z), 2e-3f) << i;
  }
}

TEST(Walker, IsTurnedAsideByTheJambOfADoor) {
  const House house = twoRooms(0.9f).build();
  for (const float z : {1.56f, 1.6f, 2.4f, 2.44f}) {
    Walker walker = walkerAt(house, {2, 1.6f, z}, kToPlusX);
    walkFor(walker, kForward, 5);
    EXPECT_GT(walker.eye().x, 4.5f) << "straight from z = " << z;
  }
}

TEST(Walker, SqueezesThroughADoorNarrowerThanItsBody) {
  for (const float width : {0.4f, 0.5f, 0.7f}) {
    const House house = twoRooms(width).build();
    Walker walker = walkerAt(house, {3, 1.6f, 2}, kToPlusX);
    walkFor(walker, kForward, 3);
    EXPECT_GT(walker.eye().x, 5.0f) << "a door of " << width << " m";
  }
}

TEST(Walker, StepsOverWhatIsBelowTheKneeAndNotOverATable) {
  HouseBuilder b = hall();
  b.solid({4, 0, 0}, {4.5f, 0.3f, 4});
  b.solid({8, 0, 0}, {8.5f, 0.5f, 4});
  const House house = b.build();
  Walker walker = walkerAt(house, {2, 1.6f, 2}, kToPlusX);
  walkFor(walker, kForward, 10);
  EXPECT_GT(walker.eye().x, 7.0f);
  EXPECT_LT(walker.eye().x, 8.0f);
}

TEST(Walker, ClimbsStairsWithoutBobbing) {
  const House house = twoStoreys().build();
  Walker walker = walkerAt(house, {0.5f, 1.6f, 0.5f}, kToPlusX);
  float before = walker.eye().y;
  float fastest = 0;
  for (int i = 0; i < 300; ++i) {
    walker.step(kForward, kFrame);
    const float speed = (walker.eye().y - before) / kFrame;
    EXPECT_GT(speed, -0.1f) << "down again at x = " << walker.eye().x;
    fastest = std::max(fastest, speed);
    before = walker.eye().y;
  }
  EXPECT_NEAR(walker.eye().y, 4.4f, 0.02f);
  // The stair rises 0.175 m over 0.27 m.
  EXPECT_LT(fastest, 1.6f * walker.gait().speed * 0.175f / 0.27f);
}

TEST(Walker, DoesNotWalkOffATerrace) {
  HouseBuilder b;
  b.solid({0, -0.2f, 0}, {6, 0, 6});
  b.solid({-9, -2, -9}, {15, -1.8f, 15});
  const House house = b.build();
  for (int i = 0; i < 16; ++i) {
    Walker walker = walkerAt(house, {3, 1.6f, 3}, 0.4f * static_cast<float>(i));
    walker.setGait({.speed = 8});
    walkFor(walker, kForward, 4);
    EXPECT_NEAR(walker.eye().y, 1.6f, 1e-3f);
    const glm::vec3 off = glm::abs(walker.eye() - glm::vec3(3, 1.6f, 3));
    EXPECT_LT(std::max(off.x, off.z), 3.0f);
  }
}

TEST(Walker, LeavesByTheFrontDoorAsFarAsTheGroundIsKnown) {
  const House house = cottage().build();
  Walker walker = walkerAt(house, {2, 1.6f, 1.95f}, -kToPlusX);
  walkFor(walker, kForward, 3);
  EXPECT_LT(walker.eye().x, -1.0f);
  EXPECT_NEAR(walker.floorHeight(), -0.1f, 1e-3f);
  walkFor(walker, kForward, 60);
  EXPECT_NEAR(walker.eye().y, 1.5f, 1e-3f);
  EXPECT_LT(walker.eye().x, -5.0f);
  EXPECT_FALSE(walker.flying());
}

TEST(Walker, AShutDoorStopsItOnEitherSideUntilItOpens) {
  HouseBuilder b = twoRooms(0.9f);
  b.solid({4.08f, 0, 1.55f}, {4.14f, 2.1f, 2.45f}, ObjectRole::kDoor);
  const House house = b.build();
  for (const float side : {-1.0f, 1.0f}) {
    Walker walker = walkerAt(house, {4.1f - 1.5f * side, 1.6f, 2}, side * kToPlusX);
    walker.setDoors(std::vector<std::uint8_t>{0});
    walkFor(walker, kForward, 3);
    EXPECT_LT(side * (walker.eye().x - 4.1f), -0.1f);
    EXPECT_GT(side * (walker.eye().x - 4.1f), -0.4f);
    walker.setDoors(std::vector<std::uint8_t>{1});
    walkFor(walker, kForward, 2);
    EXPECT_GT(side * (walker.eye().x - 4.1f), 0.5f);
  }
}

TEST(Walker, FindsTheDoorsAsTheyStandInTheHouse) {
  House house = twoRooms(0.9f).build();
  house.graph.portals[0].active = false;
  Walker walker = walkerAt(house, {2, 1.6f, 2}, kToPlusX);
  walkFor(walker, kForward, 3);
  EXPECT_LT(walker.eye().x, 4.1f);
  walker.setDoors(std::vector<std::uint8_t>{1});
  walkFor(walker, kForward, 3);
  EXPECT_GT(walker.eye().x, 5.0f);
}

TEST(Walker, MayLeaveADoorThatIsShutOnIt) {
  const House house = twoRooms(0.9f).build();
  Walker walker = walkerAt(house, {4.05f, 1.6f, 2}, -kToPlusX);
  walker.setDoors(std::vector<std::uint8_t>{0});
  walkFor(walker, kForward, 1);
  EXPECT_LT(walker.eye().x, 3.5f);
}

TEST(Walker, PlacedInFurnitureItStandsBesideIt) {
  HouseBuilder b = twoRooms(0.9f);
  b.solid({1, 0, 1}, {2, 0.75f, 2});
  b.solid({3, 0, 0}, {3.6f, 2.6f, 0.6f});
  const House house = b.build();
  for (const glm::vec3& eye : {glm::vec3(1.5f, 1.6f, 1.5f), glm::vec3(3.3f, 1.6f, 0.3f)}) {
    const Walker walker = walkerAt(house, eye, 0);
    EXPECT_NEAR(walker.eye().y, 1.6f, 1e-3f);
    EXPECT_LT(glm::length(walker.eye() - eye), 1.0f);
    EXPECT_LT(walker.eye().x, 4.0f) << "in the same room";
  }
}

TEST(Walker, IsPlacedOnTheStoreyThatItsEyeIsIn) {
  const House house = twoStoreys().build();
  Walker walker(house);
  walker.place({6, 4.6f, 2});
  EXPECT_NEAR(walker.eye().y, 4.4f, 1e-3f);
  walker.place({6, 2.2f, 2});
  EXPECT_NEAR(walker.eye().y, 1.6f, 1e-3f);
}

TEST(Walker, StandsInEachCellAndLooksAtItsDoor) {
  const House house = twoRooms(0.9f).build();
  Walker walker(house);
  ASSERT_TRUE(walker.placeInCell(1));
  EXPECT_LT(walker.eye().x, 4.0f);
  EXPECT_GT((walker.pose().world_from_camera_rotation * glm::vec3(0, 0, -1)).x, 0.9f);
  ASSERT_TRUE(walker.placeInCell(2));
  EXPECT_GT(walker.eye().x, 4.2f);
  EXPECT_LT((walker.pose().world_from_camera_rotation * glm::vec3(0, 0, -1)).x, -0.9f);
}

TEST(Walker, FliesInACellWhereNobodyCanStand) {
  HouseBuilder b = twoRooms(0.9f);
  const CellId shaft = b.cell("shaft", {20, 0, 0}, {22, 3, 2});
  b.triangle({20, 3, 0}, {22, 3, 0}, {22, 3, 2});
  const House house = b.build();
  Walker walker(house);
  EXPECT_FALSE(walker.placeInCell(shaft));
  EXPECT_TRUE(walker.flying());
  EXPECT_EQ(locate(house.graph, house.grid, walker.eye()).cell, shaft);
}

TEST(Walker, FliesThroughWallsWhereItLooksButNotOutOfSight) {
  const House house = twoRooms(0.9f).build();
  Walker walker = walkerAt(house, {2, 1.6f, 3.4f}, kToPlusX);
  walker.setFlying(true);
  walkFor(walker, kForward, 3);
  EXPECT_GT(walker.eye().x, 5.0f);
  EXPECT_NEAR(walker.eye().y, 1.6f, 1e-3f);
  walker.look(kToPlusX, 0.5f);
  walkFor(walker, kForward, 1);
  EXPECT_GT(walker.eye().y, 2.0f);
  walker.setGait({.speed = 50});
  for (int i = 0; i < 100; ++i) walker.step({.forward = 1, .up = 1}, 1);
  EXPECT_TRUE(walker.ground().flightBounds().contains(walker.eye()));
}

TEST(Walker, LandsAtTheNearestPlaceToStand) {
  const House house = twoRooms(0.9f).build();
  Walker walker(house);
  walker.setFlying(true);
  walker.place({6, 2.3f, 1});
  EXPECT_EQ(walker.eye(), glm::vec3(6, 2.3f, 1));
  EXPECT_TRUE(std::isnan(walker.floorHeight()));
  walker.setFlying(false);
  EXPECT_LT(glm::length(walker.eye() - glm::vec3(6, 1.6f, 1)), 0.1f);
}

TEST(Walker, OnNoFloorAtAllItFlies) {
  HouseBuilder b;
  b.triangle({0, 0, 0}, {0, 3, 0}, {0, 3, 3});
  const House house = b.build();
  Walker walker(house);
  EXPECT_TRUE(walker.flying());
  walker.setFlying(false);
  EXPECT_TRUE(walker.flying());
  walker.step(kForward, 0.5f);
  EXPECT_TRUE(std::isfinite(glm::length(walker.eye())));
}

TEST(Walker, InAHouseWithoutGeometryItFlies) {
  House house;
  house.graph.cells.emplace_back();
  house.graph.storeys.emplace_back();
  Walker walker(house);
  walker.step(kForward, 0.5f);
  EXPECT_TRUE(walker.flying());
  EXPECT_TRUE(std::isfinite(glm::length(walker.eye())));
}

TEST(Walker, NumbersThatAreNoneDoNotMoveIt) {
  const House house = twoRooms(0.9f).build();
  const float infinite = std::numeric_limits<float>::infinity();
  Walker walker = walkerAt(house, {2, 1.6f, 2}, 1);
  for (const bool flying : {false, true}) {
    walker.setFlying(flying);
    const glm::vec3 eye = walker.eye();
    for (const float bad : {kNan, infinite, -infinite}) {
      walker.step({bad, bad, bad}, 0.1f);
      walker.step({}, bad);
      walker.turn(bad, bad);
      walker.place({1, bad, 1});
      EXPECT_EQ(walker.eye(), eye);
      EXPECT_EQ(walker.yaw(), 1.0f);
      EXPECT_EQ(walker.pitch(), 0.0f);
    }
  }
  walker.setGait({kNan, kNan});
  walker.step(kForward, -1);
  walker.step(kForward, 0);
  EXPECT_TRUE(std::isfinite(walker.eye().x));
}

TEST(Walker, NeverLooksQuiteStraightUpOrDown) {
  const House house = twoRooms(0.9f).build();
  Walker walker(house);
  walker.turn(0, 100);
  EXPECT_LT(walker.pitch(), glm::half_pi<float>());
  EXPECT_GT(walker.pitch(), 1.5f);
  walker.turn(100, -200);
  EXPECT_GT(walker.pitch(), -glm::half_pi<float>());
  EXPECT_LE(std::abs(walker.yaw()), glm::pi<float>());
}

TEST(WalkGround, MayBeMadeInAnotherThreadAndShared) {
  const House house = twoRooms(0.9f).build();
  std::shared_ptr<const WalkGround> ground;
  std::thread([&] { ground = std::make_shared<const WalkGround>(house); }).join();
  Walker a(ground);
  Walker b(ground);
  walkFor(a, kForward, 1);
  EXPECT_NE(a.eye(), b.eye());
}

TEST(WalkBarrier, DistanceIsThatToItsConvexOutline) {
  HouseBuilder b = twoRooms(1.0f);
  b.solid({4.2f, 0, 1.5f}, {4.3f, 2.1f, 2.5f}, ObjectRole::kDoor);
  const WalkBarrier barrier = walkBarriers(b.build()).at(0);
  // From the portal at x = 4.1 to the far face of the leaf.
  EXPECT_NEAR(barrier.distance({4.0f, 2}, 9), 0.1f, 1e-4f);
  EXPECT_NEAR(barrier.distance({4.5f, 2}, 9), 0.2f, 1e-4f);
  EXPECT_NEAR(barrier.distance({4.2f, 2}, 9), -0.1f, 1e-4f);
  EXPECT_NEAR(barrier.distance({4.6f, 2.9f}, 9), 0.5f, 1e-4f);
  EXPECT_EQ(barrier.distance({9, 2}, 1), 1);
}

}  // namespace
}  // namespace enfilade
