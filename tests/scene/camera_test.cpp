#include "scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>
#include <random>

namespace enfilade {
namespace {

constexpr float kHalfPi = glm::half_pi<float>();

void expectNear(const glm::vec3& a, const glm::vec3& b, float tolerance = 1e-5f) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
}

glm::vec3 forwardOf(const Pose& pose) {
  return pose.world_from_camera_rotation * glm::vec3(0, 0, -1);
}
glm::vec3 upOf(const Pose& pose) { return pose.world_from_camera_rotation * glm::vec3(0, 1, 0); }

TEST(LookAt, PutsTheTargetOnTheAxisAndKeepsTheHorizonLevel) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-10.0f, 10.0f);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 eye(uniform(random), uniform(random), uniform(random));
    const glm::vec3 target(uniform(random), uniform(random), uniform(random));
    const Pose pose = lookAt(eye, target);
    expectNear(forwardOf(pose), glm::normalize(target - eye));
    const glm::vec3 right = pose.world_from_camera_rotation * glm::vec3(1, 0, 0);
    EXPECT_NEAR(right.y, 0.0f, 1e-5f);
    EXPECT_GE(upOf(pose).y, 0.0f);
    EXPECT_NEAR(glm::length(pose.world_from_camera_rotation), 1.0f, 1e-6f);
  }
}

TEST(LookAt, LooksStraightUpAndDown) {
  for (const float y : {-3.0f, 3.0f}) {
    const Pose pose = lookAt({1, 2, 3}, {1, 2 + y, 3});
    expectNear(forwardOf(pose), {0, y > 0 ? 1 : -1, 0});
  }
  expectNear(upOf(lookAt({0, 5, 0}, {0, 0, 0})), {0, 0, -1});
}

TEST(PoseFromAngles, TurnsLeftAndLooksUpForPositiveAngles) {
  expectNear(forwardOf(poseFromAngles({}, 0, 0)), {0, 0, -1});
  expectNear(forwardOf(poseFromAngles({}, kHalfPi, 0)), {-1, 0, 0});
  expectNear(forwardOf(poseFromAngles({}, 0, kHalfPi)), {0, 1, 0});
  // Pitch is about the camera's own axis: the heading stays.
  const glm::vec3 forward = forwardOf(poseFromAngles({}, kHalfPi, 0.5f));
  expectNear(forward, {-std::cos(0.5f), std::sin(0.5f), 0});
}

TEST(Interpolate, MeetsBothEndsAndTurnsHalfWay) {
  const Pose a = poseFromAngles({0, 0, 0}, 0.2f, 0);
  const Pose b = poseFromAngles({4, 2, -6}, 1.0f, 0);
  expectNear(interpolate(a, b, 0).position, a.position);
  expectNear(forwardOf(interpolate(a, b, 1)), forwardOf(b));
  const Pose middle = interpolate(a, b, 0.5f);
  expectNear(middle.position, {2, 1, -3});
  expectNear(forwardOf(middle), forwardOf(poseFromAngles({}, 0.6f, 0)));
}

TEST(Interpolate, GoesTheShortWayRound) {
  const Pose a = poseFromAngles({}, 0.1f, 0);
  Pose b = poseFromAngles({}, 0.3f, 0);
  b.world_from_camera_rotation = -b.world_from_camera_rotation;  // the same rotation
  expectNear(forwardOf(interpolate(a, b, 0.5f)), forwardOf(poseFromAngles({}, 0.2f, 0)));
}

TEST(Camera, ItsTwoMatricesUndoEachOther) {
  Camera camera;
  camera.pose = lookAt({3, 1.6f, -7}, {-2, 0, 4});
  const glm::mat4 identity = camera.worldFromCamera() * camera.cameraFromWorld();
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(identity[c][r], c == r ? 1.0f : 0.0f, 1e-5f);
  }
}

TEST(Camera, ProjectsTheEdgesOfItsFieldOfViewToTheEdgesOfTheScreen) {
  Camera camera;
  camera.pose = lookAt({1, 2, 3}, {1, 2, -10});
  camera.vertical_fov = 1.0f;
  camera.aspect = 1.6f;
  const float top = 5.0f * std::tan(0.5f);
  const glm::vec4 corner = camera.clipFromWorld() * glm::vec4(1 + 1.6f * top, 2 + top, 3 - 5.0f, 1);
  EXPECT_NEAR(corner.x / corner.w, 1.0f, 1e-5f);
  EXPECT_NEAR(corner.y / corner.w, 1.0f, 1e-5f);
  const glm::vec4 near = camera.clipFromWorld() * glm::vec4(1, 2, 3 - camera.near_plane, 1);
  const glm::vec4 far = camera.clipFromWorld() * glm::vec4(1, 2, 3 - camera.far_plane, 1);
  EXPECT_NEAR(near.z / near.w, -1.0f, 1e-4f);
  EXPECT_NEAR(far.z / far.w, 1.0f, 1e-4f);
}

TEST(Camera, ItsViewIsItsEyeAndItsProjection) {
  Camera camera;
  camera.pose = lookAt({3, 1.6f, -7}, {-2, 0, 4});
  EXPECT_EQ(camera.view().eye, camera.pose.position);
  EXPECT_EQ(camera.view().clip_from_world, camera.clipFromWorld());
}

}  // namespace
}  // namespace enfilade
