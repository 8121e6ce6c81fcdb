#include "app/path_recorder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "app/path_player.h"
#include "scene/error.h"
#include "tests/app/temporary_folder.h"
#include "tests/preprocess/tour_buildings.h"

namespace enfilade {
namespace {

Pose poseOfTime(double t) {
  const auto f = static_cast<float>(t);
  return poseFromAngles({std::sin(f), 1.6f, 0.5f * f}, 1.3f * f, 0.3f * std::sin(2 * f));
}

float angleBetween(const glm::quat& a, const glm::quat& b) {
  return 2 * std::acos(std::min(1.0f, std::abs(glm::dot(a, b))));
}

/// Poses from 0 on, evenly spaced, unit rotations without a change of sign.
void expectEven(const CameraPath& path, double rate) {
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const glm::quat& q = path.poses[i].pose.world_from_camera_rotation;
    EXPECT_NEAR(path.poses[i].time, static_cast<double>(i) / rate, 1e-9);
    EXPECT_NEAR(glm::length(q), 1, 1e-5f);
    const TimedPose& before = path.poses[i > 0 ? i - 1 : 0];
    EXPECT_GE(glm::dot(q, before.pose.world_from_camera_rotation), 0);
  }
}

TEST(PathRecorder, GivesTheWalkAtItsOwnRateHoweverTheFramesCame) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> gap(0.002, 0.05);
  PathRecorder recorder({.name = "mine"});
  double t = 0;
  for (; t < 20; t += gap(random)) {
    Pose pose = poseOfTime(t);
    if (random() % 2 == 0) {
      pose.world_from_camera_rotation = -pose.world_from_camera_rotation;
    }
    EXPECT_TRUE(recorder.addFrame(1000 + t, pose));
  }
  const CameraPath& path = recorder.path();
  EXPECT_EQ(path.name, "mine");
  EXPECT_NEAR(static_cast<double>(path.poses.size()), 30 * 20, 2);
  expectEven(path, 30);
  for (const TimedPose& timed : path.poses) {
    const Pose truth = poseOfTime(timed.time);
    EXPECT_LT(glm::length(timed.pose.position - truth.position), 1e-3f);
    EXPECT_LT(angleBetween(timed.pose.world_from_camera_rotation, truth.world_from_camera_rotation),
              3e-3f);
  }
}

TEST(PathRecorder, KeepsAWalkThatComesAtItsRate) {
  PathRecorder recorder({.frames_per_second = 25});
  for (int i = 0; i < 100; ++i) recorder.addFrame(i / 25.0, poseOfTime(i / 25.0));
  ASSERT_EQ(recorder.path().poses.size(), 100u);
  expectEven(recorder.path(), 25);
  for (const TimedPose& timed : recorder.path().poses) {
    EXPECT_LT(glm::length(timed.pose.position - poseOfTime(timed.time).position), 1e-5f);
  }
}

TEST(PathRecorder, StandsStillThroughALongGap) {
  PathRecorder recorder;
  recorder.addFrame(5, {.position = {0, 0, 0}});
  recorder.addFrame(15, {.position = {1, 0, 0}});
  const CameraPath& path = recorder.path();
  ASSERT_EQ(path.poses.size(), 301u);
  for (const TimedPose& timed : path.poses) {
    EXPECT_TRUE(timed.time > 9.7 || timed.pose.position.x == 0) << timed.time;
  }
  EXPECT_NEAR(path.poses.back().pose.position.x, 1, 1e-6f);
}

TEST(PathRecorder, LeavesOutWhatIsNoNumberAndWhatIsEarlier) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PathRecorder recorder;
  recorder.addFrame(nan, {});
  recorder.addFrame(0, {.position = {nan, 0, 0}});
  EXPECT_TRUE(recorder.path().poses.empty());
  recorder.addFrame(1, {});
  recorder.addFrame(1.5, {.world_from_camera_rotation = {0, 0, 0, 0}});
  recorder.addFrame(1.6, {.world_from_camera_rotation = {nan, 0, 0, 0}});
  recorder.addFrame(0.2, {.position = {9, 9, 9}});
  recorder.addFrame(2, {});
  recorder.addDoor(nan, "0", false);
  EXPECT_EQ(recorder.path().poses.size(), 31u);
  EXPECT_TRUE(recorder.path().doors.empty());
  for (const TimedPose& timed : recorder.path().poses) {
    EXPECT_EQ(timed.pose.position, glm::vec3(0));
  }
}

TEST(PathRecorder, EndsAtItsGreatestLengthAndSaysSo) {
  PathRecorder recorder({.longest = 10});
  double t = 0;
  while (recorder.addFrame(t, poseOfTime(t)) && t < 60) t += 0.1;
  EXPECT_NEAR(t, 10.1, 0.11);
  EXPECT_TRUE(recorder.full());
  EXPECT_EQ(recorder.duration(), 10);
  ASSERT_EQ(recorder.path().poses.size(), 301u);
  EXPECT_FALSE(recorder.addFrame(11, {}));
  recorder.addDoor(11, "0", true);
  EXPECT_EQ(recorder.path().poses.size(), 301u);
  EXPECT_TRUE(recorder.path().doors.empty());
}

TEST(PathRecorder, OneLateFrameDoesNotFillMoreThanItsGreatestLength) {
  PathRecorder recorder({.longest = 10});
  recorder.addFrame(0, {});
  EXPECT_FALSE(recorder.addFrame(1e12, {}));
  EXPECT_EQ(recorder.path().poses.size(), 301u);
}

TEST(PathRecorder, KeepsTheDoorsThatChange) {
  PathRecorder recorder;
  recorder.addDoors(0, std::vector<std::uint8_t>{1, 1, 0});
  recorder.addDoors(1, std::vector<std::uint8_t>{1, 0, 0});
  recorder.addFrame(4, {});
  recorder.addDoors(5, std::vector<std::uint8_t>{1, 0, 0});
  recorder.addDoors(6, std::vector<std::uint8_t>{0, 1, 0});
  recorder.addDoor(5, "hall*", true);
  const auto& doors = recorder.path().doors;
  ASSERT_EQ(doors.size(), 4u);
  EXPECT_EQ(doors[0].portal, "1");
  EXPECT_EQ(doors[0].time, 0) << "before the path begins";
  EXPECT_FALSE(doors[0].open);
  EXPECT_EQ(doors[1].portal, "0");
  EXPECT_EQ(doors[2].portal, "1");
  EXPECT_TRUE(doors[2].open);
  EXPECT_EQ(doors[2].time, 2);
  EXPECT_EQ(doors[3].time, 2) << "never before the last";
}

TEST(PathRecorder, ItsFileReadsBackTheSame) {
  const TemporaryFolder folder;
  PathRecorder recorder({.vertical_fov = 1.2f, .name = "ä \"walk\""});
  for (int i = 0; i < 200; ++i) recorder.addFrame(0.017 * i, poseOfTime(0.017 * i));
  recorder.addDoor(2, "0", false);
  const CameraPath& path = recorder.path();
  writeCameraPath(folder / "walk.json", path);
  const CameraPath read = readCameraPath(folder / "walk.json");
  EXPECT_EQ(read.name, path.name);
  EXPECT_FLOAT_EQ(read.vertical_fov, path.vertical_fov);
  ASSERT_EQ(read.doors.size(), 1u);
  EXPECT_EQ(read.doors[0].time, path.doors[0].time);
  ASSERT_EQ(read.poses.size(), path.poses.size());
  for (std::size_t i = 0; i < read.poses.size(); ++i) {
    EXPECT_EQ(read.poses[i].time, path.poses[i].time);
    EXPECT_EQ(read.poses[i].pose.position, path.poses[i].pose.position);
    EXPECT_LT(angleBetween(read.poses[i].pose.world_from_camera_rotation,
                           path.poses[i].pose.world_from_camera_rotation),
              1e-3f);
  }
}

House houseWithADoor() {
  testing::HouseBuilder b = testing::twoRooms(1.0f);
  b.solid({4.08f, 0, 1.5f}, {4.14f, 2.1f, 2.5f}, ObjectRole::kDoor);
  return b.build();
}

CameraPath straightPath() {
  CameraPath path;
  for (int i = 0; i <= 4; ++i) {
    path.poses.push_back({100 + 0.5 * i, {.position = {static_cast<float>(i), 0, 0}}});
  }
  path.doors = {{100.75, "0", false}, {101.5, "0", true}};
  return path;
}

TEST(PathPlayer, GoesEvenlyFromPoseToPoseAndStaysAtTheEnds) {
  const PathPlayer player(straightPath(), houseWithADoor(), "p.json");
  EXPECT_EQ(player.duration(), 2);
  for (double t = 0; t <= 2; t += 0.0625) {
    EXPECT_NEAR(player.poseAt(t).position.x, 2 * t, 1e-5) << t;
  }
  EXPECT_EQ(player.poseAt(-5).position.x, 0);
  EXPECT_EQ(player.poseAt(50).position.x, 4);
}

TEST(PathPlayer, OfTwoPosesAtOneTimeTheLaterCounts) {
  CameraPath path = straightPath();
  path.poses[2].time = path.poses[1].time;
  const PathPlayer player(path, houseWithADoor(), "p.json");
  EXPECT_EQ(player.poseAt(0.5).position.x, 2);
  EXPECT_NEAR(player.poseAt(0.25).position.x, 0.5f, 1e-6f);
}

TEST(PathPlayer, MovesTheDoorsWhenThePathSaysInEitherDirectionOfTime) {
  const PathPlayer player(straightPath(), houseWithADoor(), "p.json");
  for (const double t : {0.0, 1.6, 0.75, 0.74, 1.49, 1.5, -3.0}) {
    ASSERT_NE(player.doorsAt(t), nullptr);
    EXPECT_EQ(player.doorsAt(t)->at(0), t < 0.75 || t >= 1.5 ? 1 : 0) << t;
  }
}

TEST(PathPlayer, WithoutEventsLeavesTheDoorsAlone) {
  CameraPath path = straightPath();
  path.doors.clear();
  EXPECT_EQ(PathPlayer(path, houseWithADoor(), "p.json").doorsAt(1), nullptr);
}

TEST(PathPlayer, NamesTheEventOfADoorThatIsNotThere) {
  CameraPath path = straightPath();
  path.doors[1].portal = "cellar";
  try {
    const PathPlayer player(path, houseWithADoor(), "p.json");
    ADD_FAILURE() << "took it";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_NE(std::string(error.what()).find("p.json: doors[1]"), std::string::npos);
  }
}

TEST(PathPlayer, PlaysWhatWasRecorded) {
  const House house = houseWithADoor();
  PathRecorder recorder;
  recorder.addDoors(0, std::vector<std::uint8_t>{1});
  for (int i = 0; i < 240; ++i) {
    if (i == 120) recorder.addDoors(i / 60.0, std::vector<std::uint8_t>{0});
    recorder.addFrame(i / 60.0, poseOfTime(i / 60.0));
  }
  const PathPlayer player(recorder.path(), house, "walk.json");
  for (double t = 0; t < 3.9; t += 0.01) {
    EXPECT_LT(glm::length(player.poseAt(t).position - poseOfTime(t).position), 1e-3f);
    EXPECT_EQ(player.doorsAt(t)->at(0), t < 2 ? 1 : 0);
  }
}

}  // namespace
}  // namespace enfilade
