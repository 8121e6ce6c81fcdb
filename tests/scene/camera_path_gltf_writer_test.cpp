#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>

#include "scene/camera_path.h"
#include "scene/gltf_container.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

CameraPath someWalk(std::size_t frames, double rate) {
  std::mt19937 random(5);
  std::uniform_real_distribution<float> uniform(-1, 1);
  CameraPath path;
  path.name = "Rundgang \"ä\"";
  path.vertical_fov = 0.9f;
  float yaw = 0;
  glm::vec3 p(3, 1.6f, -2);
  for (std::size_t i = 0; i < frames; ++i) {
    p += 0.05f * glm::vec3(uniform(random), 0.1f * uniform(random), uniform(random));
    yaw += 0.2f * uniform(random);
    Pose pose = poseFromAngles(p, yaw, 0.2f * uniform(random));
    if (random() % 2 == 0) pose.world_from_camera_rotation = -pose.world_from_camera_rotation;
    path.poses.push_back({static_cast<double>(i) / rate, pose});
  }
  return path;
}

float angleBetween(const glm::quat& a, const glm::quat& b) {
  return 2 * std::asin(std::min(1.0f, glm::length(glm::dot(a, b) < 0 ? a + b : a - b) / 2));
}

void expectSame(const CameraPath& read, const CameraPath& path) {
  EXPECT_EQ(read.name, path.name);
  EXPECT_FLOAT_EQ(read.vertical_fov, path.vertical_fov);
  ASSERT_EQ(read.poses.size(), path.poses.size());
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const Pose& a = read.poses[i].pose;
    const Pose& b = path.poses[i].pose;
    EXPECT_NEAR(read.poses[i].time, path.poses[i].time, 1e-9) << i;
    EXPECT_LT(glm::length(a.position - b.position), 2e-4f) << i;
    EXPECT_LT(angleBetween(a.world_from_camera_rotation, b.world_from_camera_rotation), 1e-3f) << i;
  }
}

Json jsonOf(const std::string& file) {
  std::span<const std::uint8_t> bin;
  WarningLog warnings;
  const std::vector<std::uint8_t> bytes = readFile(file);
  return parseGltfContainer(file, bytes, bin, warnings);
}

/// The numbers of an accessor, by tinygltf.
std::vector<float> numbersOf(const tinygltf::Model& model, int accessor) {
  const tinygltf::Accessor& a = model.accessors.at(static_cast<std::size_t>(accessor));
  const auto& view = model.bufferViews.at(static_cast<std::size_t>(a.bufferView));
  const auto& bytes = model.buffers.at(static_cast<std::size_t>(view.buffer)).data;
  const auto components = static_cast<std::size_t>(
      tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type)));
  std::vector<float> numbers(a.count * components);
  EXPECT_EQ(a.componentType, TINYGLTF_COMPONENT_TYPE_FLOAT);
  EXPECT_EQ(view.byteLength, 4 * numbers.size());
  EXPECT_LE(view.byteOffset + view.byteLength, bytes.size());
  EXPECT_EQ(view.byteOffset % 4, 0u);
  std::memcpy(numbers.data(), bytes.data() + view.byteOffset, 4 * numbers.size());
  return numbers;
}

class GltfPath : public ::testing::TestWithParam<const char*> {
 protected:
  std::string file() const { return folder_ / (std::string("walk") + GetParam()); }
  TempFolder folder_;
};

INSTANTIATE_TEST_SUITE_P(Each, GltfPath, ::testing::Values(".gltf", ".glb"),
                         [](const auto& test) { return test.param + 1; });

TEST_P(GltfPath, ReadsBackTheSameAtItsOwnRate) {
  for (const double rate : {30.0, 24.0, 12.5}) {
    const CameraPath path = someWalk(200, rate);
    writeGltfPath(file(), path);
    expectSame(readCameraPath(file(), rate), path);
  }
}

TEST_P(GltfPath, OfTwoHoursKeepsItsLastFrame) {
  const CameraPath path = someWalk(30 * 7200 + 1, 30);
  writeGltfPath(file(), path);
  const CameraPath read = readCameraPath(file());
  ASSERT_EQ(read.poses.size(), path.poses.size());
  EXPECT_LT(glm::length(read.poses.back().pose.position - path.poses.back().pose.position), 1e-3f);
}

TEST_P(GltfPath, IsAsTheSpecificationAsks) {
  writeGltfPath(file(), someWalk(50, 30));
  const Json root = jsonOf(file());
  EXPECT_EQ(root["asset"]["version"], "2.0");
  EXPECT_EQ(root["scenes"][0]["nodes"], Json::array({0}));
  EXPECT_EQ(root["nodes"][0]["camera"], 0);
  const Json& camera = root["cameras"][0];
  EXPECT_EQ(camera["type"], "perspective");
  EXPECT_GT(camera["perspective"]["znear"], 0);
  const Json& animation = root["animations"][0];
  ASSERT_EQ(animation["channels"].size(), 2u);
  for (const Json& channel : animation["channels"]) {
    EXPECT_EQ(channel["target"]["node"], 0);
    const Json& sampler = animation["samplers"].at(channel["sampler"].get<std::size_t>());
    EXPECT_EQ(sampler["interpolation"], "LINEAR");
    const Json& input = root["accessors"].at(sampler["input"].get<std::size_t>());
    const Json& output = root["accessors"].at(sampler["output"].get<std::size_t>());
    EXPECT_EQ(input["type"], "SCALAR");
    EXPECT_EQ(input["count"], output["count"]);
    EXPECT_EQ(input["min"], Json::array({0.0}));
    EXPECT_EQ(input["max"].size(), 1u);
    EXPECT_EQ(output["type"], channel["target"]["path"] == "rotation" ? "VEC4" : "VEC3");
  }
  EXPECT_EQ(root["buffers"][0].contains("uri"), std::string(GetParam()) == ".gltf");
}

TEST_P(GltfPath, AnotherReaderTakesItAndFindsUnitRotationsOfOneSign) {
  writeGltfPath(file(), someWalk(50, 30));
  tinygltf::TinyGLTF loader;
  tinygltf::Model model;
  std::string error, warning;
  const bool text = std::string(GetParam()) == ".gltf";
  ASSERT_TRUE(text ? loader.LoadASCIIFromFile(&model, &error, &warning, file())
                   : loader.LoadBinaryFromFile(&model, &error, &warning, file()))
      << error;
  EXPECT_EQ(error + warning, "");
  const auto& samplers = model.animations.at(0).samplers;
  const std::vector<float> times = numbersOf(model, samplers.at(0).input);
  for (std::size_t i = 1; i < times.size(); ++i) EXPECT_GT(times[i], times[i - 1]);
  EXPECT_EQ(model.accessors[0].maxValues.at(0), static_cast<double>(times.back()));
  const std::vector<float> q = numbersOf(model, samplers.at(1).output);
  ASSERT_EQ(q.size(), 4 * times.size());
  for (std::size_t i = 0; i < q.size(); i += 4) {
    const glm::vec4 a(q[i], q[i + 1], q[i + 2], q[i + 3]);
    EXPECT_NEAR(glm::length(a), 1, 1e-6f);
    if (i < 4) continue;
    EXPECT_GT(glm::dot(a, glm::vec4(q[i - 4], q[i - 3], q[i - 2], q[i - 1])), 0);
  }
}

TEST_P(GltfPath, OfPosesAtOneTimeKeepsTheLast) {
  CameraPath path = someWalk(6, 1);
  path.poses[1].time = path.poses[2].time = path.poses[3].time = 2;
  path.poses[5].time = path.poses[4].time = 4 + 1e-12;
  writeGltfPath(file(), path);
  const CameraPath read = readCameraPath(file(), 1);
  ASSERT_EQ(read.poses.size(), 5u);
  EXPECT_LT(glm::length(read.poses[2].pose.position - path.poses[3].pose.position), 1e-5f);
  EXPECT_LT(glm::length(read.poses[4].pose.position - path.poses[5].pose.position), 1e-5f);
}

TEST_P(GltfPath, OfATimeOfDayBeginsAtZero) {
  CameraPath path = someWalk(40, 30);
  for (TimedPose& timed : path.poses) timed.time += 1.7e9;
  writeGltfPath(file(), path);
  const CameraPath read = readCameraPath(file());
  ASSERT_EQ(read.poses.size(), 40u);
  EXPECT_EQ(read.poses.front().time, 0.0);
  EXPECT_LT(glm::length(read.poses[20].pose.position - path.poses[20].pose.position), 1e-3f);
}

TEST_P(GltfPath, MayHoldASinglePose) {
  const CameraPath path = someWalk(1, 30);
  writeGltfPath(file(), path);
  expectSame(readCameraPath(file()), path);
}

TEST(PathFormat, IsChosenByTheExtension) {
  EXPECT_EQ(pathFormatOf("a.json"), PathFormat::kTour);
  EXPECT_EQ(pathFormatOf("a"), PathFormat::kTour);
  EXPECT_EQ(pathFormatOf("x.glb/a.txt"), PathFormat::kTum);
  EXPECT_EQ(pathFormatOf("a.tum"), PathFormat::kTum);
  EXPECT_EQ(pathFormatOf("a.gltf"), PathFormat::kGltf);
  EXPECT_EQ(pathFormatOf("a.b.glb"), PathFormat::kGltf);
}

TEST(PathFormat, EachReadsBackTheSame) {
  const TempFolder folder;
  const CameraPath path = someWalk(30, 30);
  for (const char* name : {"walk.json", "walk.tum", "walk.gltf", "walk.glb"}) {
    writePath(folder / name, path, pathFormatOf(name));
    const CameraPath read = readCameraPath(folder / name);
    ASSERT_EQ(read.poses.size(), path.poses.size()) << name;
    EXPECT_LT(glm::length(read.poses[17].pose.position - path.poses[17].pose.position), 1e-4f);
  }
}

}  // namespace
}  // namespace enfilade
