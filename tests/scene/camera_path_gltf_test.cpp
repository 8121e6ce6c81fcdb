#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "gltf_builder.h"
#include "scene/camera_path.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;
constexpr float kHalf = 0.70710678f;  ///< sin and cos of half a right angle

/// A camera below a turned parent; tests animate them.
class AnimatedCamera : public testing::Test {
 protected:
  AnimatedCamera() {
    builder_.add("cameras",
                 {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}});
    builder_.add("nodes", {{"name", "rail"}, {"children", {1}}});
    builder_.add("nodes", {{"name", "eye"}, {"camera", 0}});
  }
  void animate(int node, const std::string& path, const std::vector<float>& times,
               const std::vector<float>& values, const std::string& interpolation) {
    const int input = builder_.accessor(times, "SCALAR", kF32);
    const int output = builder_.accessor(values, path == "rotation" ? "VEC4" : "VEC3", kF32);
    Json animation = Json::object();
    animation["samplers"] =
        Json::array({Json{{"input", input}, {"output", output}, {"interpolation", interpolation}}});
    animation["channels"] =
        Json::array({Json{{"sampler", 0}, {"target", {{"node", node}, {"path", path}}}}});
    builder_.add("animations", animation);
  }
  CameraPath read(double frames_per_second) {
    return readCameraPath(folder_.file("path.glb", builder_.glb()), frames_per_second);
  }
  void expectBad(const std::string& words) {
    const std::string file = folder_.file("path.glb", builder_.glb());
    expectError([&] { readCameraPath(file); }, ErrorKind::kBadInput, file, words);
  }
  static glm::vec3 forwardOf(const TimedPose& pose) {
    return pose.pose.world_from_camera_rotation * glm::vec3(0, 0, -1);
  }
  static void expectNear(const glm::vec3& a, const glm::vec3& b) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-5f) << "component " << i;
  }

  GltfBuilder builder_;
  TempFolder folder_;
};

TEST_F(AnimatedCamera, MovesAlongStraightLinesByLinear) {
  animate(1, "translation", {1, 2, 4}, {0, 0, 0, 2, 0, 0, 2, 6, 0}, "LINEAR");
  const CameraPath path = read(2);
  EXPECT_EQ(path.name, "eye");
  EXPECT_FLOAT_EQ(path.vertical_fov, 0.8f);
  ASSERT_EQ(path.poses.size(), 7u) << "1 s to 4 s, twice a second, both ends";
  EXPECT_EQ(path.poses[0].time, 0.0);
  EXPECT_EQ(path.poses[6].time, 3.0);
  expectNear(path.poses[1].pose.position, {1, 0, 0});
  expectNear(path.poses[2].pose.position, {2, 0, 0});
  expectNear(path.poses[3].pose.position, {2, 1.5f, 0});
  expectNear(path.poses[6].pose.position, {2, 6, 0});
}

TEST_F(AnimatedCamera, JumpsByStep) {
  animate(1, "translation", {0, 1}, {0, 0, 0, 5, 0, 0}, "STEP");
  const CameraPath path = read(4);
  ASSERT_EQ(path.poses.size(), 5u);
  for (std::size_t i = 0; i < 4; ++i) expectNear(path.poses[i].pose.position, {0, 0, 0});
  expectNear(path.poses[4].pose.position, {5, 0, 0});
}

TEST_F(AnimatedCamera, FollowsTheCubicThatItsTangentsGive) {
  // x(t) = t³ − 2t² + 5 on [1, 3]: a cubic, so Hermite interpolation gives it exactly.
  const auto x = [](float t) { return t * t * t - 2 * t * t + 5; };
  const auto slope = [](float t) { return 3 * t * t - 4 * t; };
  std::vector<float> values;
  for (const float t : {1.0f, 3.0f}) {
    for (const float v : {slope(t), x(t), slope(t)}) values.insert(values.end(), {v, 0, 0});
  }
  animate(1, "translation", {1, 3}, values, "CUBICSPLINE");
  const CameraPath path = read(10);
  ASSERT_EQ(path.poses.size(), 21u);
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const float t = 1.0f + 0.1f * static_cast<float>(i);
    EXPECT_NEAR(path.poses[i].pose.position.x, x(t), 1e-4f) << i;
  }
}

TEST_F(AnimatedCamera, TurnsEvenlyTheShortWayRound) {
  // From 0 to 90° to the left, the second key with its sign reversed.
  animate(1, "rotation", {0, 1}, {0, 0, 0, 1, 0, -kHalf, 0, -kHalf}, "LINEAR");
  const CameraPath path = read(3);
  ASSERT_EQ(path.poses.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const float angle = glm::radians(30.0f * static_cast<float>(i));
    expectNear(forwardOf(path.poses[i]), {-std::sin(angle), 0, -std::cos(angle)});
  }
}

TEST_F(AnimatedCamera, NormalisesRotationsOfACubic) {
  animate(1, "rotation", {0, 1},
          {0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, kHalf, 0, kHalf, 0, 0, 0, 0},
          "CUBICSPLINE");
  const CameraPath path = read(2);
  ASSERT_EQ(path.poses.size(), 3u);
  const float angle = glm::radians(45.0f);  // by symmetry
  expectNear(forwardOf(path.poses[1]), {-std::sin(angle), 0, -std::cos(angle)});
}

TEST_F(AnimatedCamera, IsCarriedByTheNodesAboveIt) {
  builder_.root["nodes"][1]["translation"] = {0, 1, 0};
  builder_.root["nodes"][0]["scale"] = {2, 2, 2};
  animate(0, "rotation", {0, 1}, {0, 0, 0, 1, 0, kHalf, 0, kHalf}, "LINEAR");
  animate(0, "translation", {0, 2}, {0, 0, 0, 8, 0, 0}, "LINEAR");
  const CameraPath path = read(1);
  ASSERT_EQ(path.poses.size(), 3u) << "to the last key of any of them";
  expectNear(path.poses[1].pose.position, {4, 2, 0});
  expectNear(forwardOf(path.poses[1]), {-1, 0, 0});
  expectNear(path.poses[2].pose.position, {8, 2, 0});
  expectNear(forwardOf(path.poses[2]), {-1, 0, 0});
}

TEST_F(AnimatedCamera, ReadsAGltfWithItsBufferInADataUri) {
  animate(1, "translation", {0, 1}, {0, 0, 0, 5, 0, 0}, "LINEAR");
  EXPECT_EQ(readCameraPath(folder_.file("p.gltf", builder_.gltf()), 1).poses.size(), 2u);
}

TEST_F(AnimatedCamera, IsFoundAmongCamerasThatStandStill) {
  builder_.root["nodes"][1]["name"] = "still";
  builder_.add("nodes", {{"name", "moving"}, {"camera", 0}});
  animate(2, "translation", {0, 1}, {0, 0, 0, 5, 0, 0}, "LINEAR");
  EXPECT_EQ(read(1).name, "moving");
}

TEST_F(AnimatedCamera, MayHaveASingleKey) {
  animate(1, "translation", {7}, {1, 2, 3}, "LINEAR");
  const CameraPath path = read(30);
  ASSERT_EQ(path.poses.size(), 1u);
  expectNear(path.poses[0].pose.position, {1, 2, 3});
}

TEST_F(AnimatedCamera, ThatIsNotAnimatedOrNotThereIsNoPath) {
  expectBad("holds a camera, but no animation of it");
  builder_.root["nodes"][1].erase("camera");
  expectBad("is glTF without a perspective camera");
}

TEST_F(AnimatedCamera, RejectsKeysThatAreOutOfOrder) {
  animate(1, "translation", {1, 1}, {0, 0, 0, 2, 0, 0}, "LINEAR");
  expectBad("the keys of an animation are not in order");
}

TEST_F(AnimatedCamera, RejectsValuesThatDoNotMatchTheKeys) {
  animate(1, "translation", {0, 1}, {0, 0, 0, 2, 0, 0}, "CUBICSPLINE");
  expectBad("has not as many values as keys");
}

TEST_F(AnimatedCamera, RejectsAnUnknownInterpolation) {
  animate(1, "translation", {0, 1}, {0, 0, 0, 2, 0, 0}, "BEZIER");
  expectBad("interpolates by \"BEZIER\"");
}

TEST_F(AnimatedCamera, RejectsAnAnimatedNodeWithAMatrix) {
  builder_.root["nodes"][1]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  animate(1, "translation", {0, 1}, {0, 0, 0, 2, 0, 0}, "LINEAR");
  expectBad("node 1 'eye' is animated but has a matrix");
}

TEST_F(AnimatedCamera, RejectsAFieldOfViewThatCannotBe) {
  animate(1, "translation", {0, 1}, {0, 0, 0, 2, 0, 0}, "LINEAR");
  builder_.root["cameras"][0]["perspective"]["yfov"] = 4.0;
  expectBad("the yfov of its camera is 229.2 degrees, not from 1 to 170");
}

TEST_F(AnimatedCamera, RejectsAnAnimationThatIsTooLongToSample) {
  animate(1, "translation", {0, 1e9f}, {0, 0, 0, 2, 0, 0}, "LINEAR");
  expectBad("too long to sample");
}

TEST_F(AnimatedCamera, RejectsAnAnimationOfMoreNodesThanCanBeSampledForSoLong) {
  for (int node = 2; node < 6; ++node)
    builder_.add("nodes", {{"children", {node - 2 == 0 ? 0 : node - 1}}});
  animate(1, "translation", {0, 3e4f}, {0, 0, 0, 2, 0, 0}, "LINEAR");
  expectBad("too long to sample");
}

TEST_F(AnimatedCamera, RejectsASamplerThatIsNotThere) {
  animate(1, "translation", {0, 1}, {0, 0, 0, 2, 0, 0}, "LINEAR");
  builder_.root["animations"][0]["channels"][0]["sampler"] = 3;
  expectBad("an animation lacks a sampler");
}

}  // namespace
}  // namespace enfilade
