#include <gtest/gtest.h>

#include "gltf_builder.h"
#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

class GltfLights : public testing::Test {
 protected:
  /// A model of one triangle, whose node has the light `light`.
  void model(const Json& light, const Json& index = 0) {
    builder_.root["extensionsUsed"] = {"KHR_lights_punctual"};
    builder_.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::array({light});
    builder_.add("nodes", {{"mesh", builder_.triangle()}});
    builder_.add("nodes", {{"name", "lamp"},
                           {"translation", {1, 2, 3}},
                           {"extensions", {{"KHR_lights_punctual", {{"light", index}}}}}});
  }
  Building read(Warnings* warnings = nullptr) {
    return readGltf(folder_.file("model.glb", builder_.glb()), warnings);
  }

  GltfBuilder builder_;
  TempFolder folder_;
};

TEST_F(GltfLights, AreReadWithTheirDefaults) {
  model({{"type", "point"}});
  const Building building = read();
  ASSERT_EQ(building.lights.size(), 1u);
  const Light& light = building.lights[0];
  EXPECT_EQ(building.nodes[light.node].name, "lamp");
  EXPECT_EQ(light.kind, LightKind::kPoint);
  EXPECT_EQ(light.color, glm::vec3(1));
  EXPECT_EQ(light.intensity, 1.0f);
  EXPECT_EQ(light.range, 0.0f);
}

TEST_F(GltfLights, ComeBackAsTheyWereWritten) {
  model({{"type", "spot"},
         {"name", "spot"},
         {"color", {1, 0.5, 0.25}},
         {"intensity", 40},
         {"range", 8},
         {"spot", {{"innerConeAngle", 0.25}, {"outerConeAngle", 0.5}}}});
  Building building = read();
  building.nodes.push_back({"sun", kNone, glm::mat4(1), {}});
  building.lights.push_back({.name = "sun",
                             .node = static_cast<std::uint32_t>(building.nodes.size() - 1),
                             .kind = LightKind::kDirectional,
                             .intensity = 5000});
  const Building again = readGltf(folder_.file("again.glb", encodeGlb(building)));
  ASSERT_EQ(again.lights.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Light& a = building.lights[i];
    const Light& b = again.lights[i];
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.node, b.node);
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.intensity, b.intensity);
    EXPECT_EQ(a.range, b.range);
    if (a.kind != LightKind::kSpot) continue;
    EXPECT_EQ(a.inner_angle, b.inner_angle);
    EXPECT_EQ(a.outer_angle, b.outer_angle);
  }
  EXPECT_EQ(encodeGlb(building), encodeGlb(again));
}

TEST_F(GltfLights, OfUnknownKindAreLeftOutWithAWarning) {
  model({{"type", "area"}, {"name", "panel"}});
  Warnings warnings;
  EXPECT_TRUE(read(&warnings).lights.empty());
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("light of unknown kind \"area\""), std::string::npos) << warnings[0];
}

TEST_F(GltfLights, WithImpossibleNumbersAreMadeSensible) {
  model({{"type", "spot"},
         {"color", {-1, 2}},
         {"intensity", -5},
         {"range", -1},
         {"spot", {{"innerConeAngle", 9}, {"outerConeAngle", 7}}}});
  const Light light = read().lights.at(0);
  EXPECT_EQ(light.color, glm::vec3(1));
  EXPECT_EQ(light.intensity, 0.0f);
  EXPECT_EQ(light.range, 0.0f);
  EXPECT_LE(light.outer_angle, 1.571f);
  EXPECT_LT(light.inner_angle, light.outer_angle);
}

TEST_F(GltfLights, ThatAreNotThereAreAnError) {
  for (const Json& index : {Json(1), Json(-1), Json("0"), Json(nullptr)}) {
    builder_ = {};
    model({{"type", "point"}}, index);
    expectError([&] { read(); }, ErrorKind::kBadInput, folder_ / "model.glb",
                "node 1 'lamp' has a light that is not there");
  }
}

TEST_F(GltfLights, OfTheWrongTypeAreBadInput) {
  for (const Json& wrong : {Json("text"), Json(7), Json::array({1}), Json(nullptr)}) {
    builder_ = {};
    model(wrong);
    try {
      read();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << wrong;
    }
    builder_.root["extensions"]["KHR_lights_punctual"]["lights"] = wrong;
    try {
      read();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << wrong;
    }
  }
}

}  // namespace
}  // namespace enfilade
