#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "gltf_builder.h"
#include "scene/gltf_reader.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

class GltfNodes : public testing::Test {
 protected:
  Building read() { return readGltf(folder_.file("model.glb", builder_.glb()), &warnings_); }
  void expectBad(const std::string& words) {
    const std::string file = folder_.file("model.glb", builder_.glb());
    expectError([&] { readGltf(file); }, ErrorKind::kBadInput, file, words);
  }
  static std::vector<std::string> namesOf(const Building& building) {
    std::vector<std::string> names;
    for (const Node& node : building.nodes) names.push_back(node.name);
    return names;
  }

  GltfBuilder builder_;
  TempFolder folder_;
  Warnings warnings_;
};

void expectNear(const glm::mat4& a, const glm::mat4& b) {
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], 1e-6f) << c << ", " << r;
  }
}

TEST_F(GltfNodes, MultipliesTransformsOfBothFormsDownTheHierarchy) {
  const int mesh = builder_.triangle();
  // 30° about y, as a quaternion that is not quite unit.
  const double angle = glm::radians(30.0);
  builder_.add("nodes", {{"name", "trs"},
                         {"translation", {1, 2, 3}},
                         {"rotation", {0, 2 * std::sin(angle / 2), 0, 2 * std::cos(angle / 2)}},
                         {"scale", {2, 3, 4}},
                         {"children", {1}}});
  builder_.add("nodes", {{"name", "matrix"},
                         {"matrix", {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}},
                         {"mesh", mesh}});
  const Building building = read();
  const glm::mat4 trs = glm::translate(glm::mat4(1), {1, 2, 3}) *
                        glm::rotate(glm::mat4(1), static_cast<float>(angle), {0, 1, 0}) *
                        glm::scale(glm::mat4(1), {2, 3, 4});
  const glm::mat4 matrix(0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1);
  ASSERT_EQ(building.nodes.size(), 2u);
  expectNear(building.nodes[0].world_from_node, trs);
  expectNear(building.nodes[1].world_from_node, trs * matrix);
  EXPECT_EQ(building.nodes[1].parent, 0u);
  expectNear(building.worldFromObject(building.objects[0]), trs * matrix);
}

TEST_F(GltfNodes, ComeParentsFirstAndOtherwiseInTheFilesOrder) {
  const int mesh = builder_.triangle();
  builder_.add("nodes", {{"name", "grandchild"}, {"mesh", mesh}});
  builder_.add("nodes", {{"name", "alone"}});
  builder_.add("nodes", {{"name", "child"}, {"children", {0}}});
  builder_.add("nodes", {{"name", "root"}, {"children", {2}}});
  const Building building = read();
  EXPECT_EQ(namesOf(building), (std::vector<std::string>{"root", "child", "grandchild", "alone"}));
  EXPECT_EQ(building.nodes[2].parent, 1u);
  EXPECT_EQ(building.nodes[3].parent, kNone);
  EXPECT_EQ(building.objects[0].node, 2u);
}

TEST_F(GltfNodes, KeepEmptiesAndTheirMarkers) {
  const int mesh = builder_.triangle();
  const Json marker{{"cell", "kitchen"}, {"nothing", nullptr}, {"list", Json::array()}};
  builder_.add("nodes", {{"name", "kitchen-room"},
                         {"extras", {{"enfilade", marker}, {"other", 1}}},
                         {"children", {1}}});
  builder_.add("nodes", {{"mesh", mesh}, {"extras", {{"other", 2}}}});
  const Building building = read();
  ASSERT_EQ(building.nodes.size(), 2u);
  EXPECT_EQ(building.nodes[0].name, "kitchen-room");
  EXPECT_EQ(Json::parse(building.nodes[0].extras), marker);
  EXPECT_EQ(building.nodes[1].extras, "");
}

TEST_F(GltfNodes, AreThoseOfTheDefaultScene) {
  const int mesh = builder_.triangle();
  for (const char* name : {"first", "second"}) {
    builder_.add("nodes", {{"name", name}, {"mesh", mesh}});
  }
  builder_.add("scenes", {{"nodes", {0}}});
  builder_.add("scenes", {{"nodes", {1}}});
  builder_.root["scene"] = 1;
  EXPECT_EQ(namesOf(read()), std::vector<std::string>{"second"});
  builder_.root.erase("scene");
  EXPECT_EQ(namesOf(read()), std::vector<std::string>{"first"});
  builder_.root.erase("scenes");
  EXPECT_EQ(namesOf(read()), (std::vector<std::string>{"first", "second"}));
}

TEST_F(GltfNodes, WithSeveralPrimitivesGiveAnObjectForEach) {
  const int positions = builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", kF32);
  for (const char* name : {"red", "green"}) builder_.add("materials", {{"name", name}});
  const auto primitive = [&](int material) {
    return Json{{"attributes", {{"POSITION", positions}}}, {"material", material}};
  };
  builder_.add("meshes", {{"primitives", {primitive(1), primitive(0)}}});
  builder_.add("nodes", {{"mesh", 0}});
  builder_.add("nodes", {{"mesh", 0}});
  const Building building = read();
  ASSERT_EQ(building.objects.size(), 4u);
  EXPECT_EQ(building.meshes.size(), 2u);
  for (std::size_t o = 0; o < 4; ++o) {
    EXPECT_EQ(building.objects[o].node, o / 2);
    EXPECT_EQ(building.materialOf(building.objects[o]).name, o % 2 == 0 ? "green" : "red");
  }
}

TEST_F(GltfNodes, ThatMirrorAreTold) {
  const int mesh = builder_.triangle();
  builder_.add("nodes", {{"mesh", mesh}, {"scale", {-1, 1, 1}}});
  builder_.add("nodes", {{"mesh", mesh}, {"scale", {-1, -1, 1}}});
  const Building building = read();
  EXPECT_TRUE(isMirrored(building.nodes[0].world_from_node));
  EXPECT_FALSE(isMirrored(building.nodes[1].world_from_node));
}

TEST_F(GltfNodes, InADeepChainDoNotExhaustTheStack) {
  const int mesh = builder_.triangle();
  constexpr int kDepth = 50'000;
  Json nodes = Json::array();
  for (int n = 0; n < kDepth; ++n) nodes.push_back({{"children", {n + 1}}});
  nodes.push_back({{"mesh", mesh}});
  builder_.root["nodes"] = nodes;
  EXPECT_EQ(read().nodes.size(), kDepth + 1u);
}

TEST_F(GltfNodes, RejectACycle) {
  builder_.triangle();
  builder_.add("nodes", {{"name", "a"}, {"children", {1}}, {"mesh", 0}});
  builder_.add("nodes", {{"name", "b"}, {"children", {0}}});
  expectBad("below itself");
  builder_.add("scenes", {{"nodes", {0}}});
  expectBad("below itself");
}

TEST_F(GltfNodes, RejectANodeBelowItself) {
  builder_.triangle();
  builder_.add("nodes", {{"children", {0}}, {"mesh", 0}});
  expectBad("below itself");
}

TEST_F(GltfNodes, RejectAChildOfTwo) {
  builder_.triangle();
  builder_.add("nodes", {{"children", {2}}});
  builder_.add("nodes", {{"children", {2}}});
  builder_.add("nodes", {{"name", "shared"}, {"mesh", 0}});
  expectBad("node 2 'shared' is the child of two nodes");
}

TEST_F(GltfNodes, RejectWhatIsNotThere) {
  builder_.triangle();
  builder_.add("nodes", {{"children", {7}}});
  expectBad("there is no node 7");
  builder_.root["nodes"] = {{{"mesh", 3}}};
  expectBad("there is no mesh 3");
  builder_.root["nodes"] = {{{"mesh", 0}}};
  builder_.root["scenes"] = {{{"nodes", {-1}}}};
  expectBad("there is no node -1");
}

TEST_F(GltfNodes, RejectATransformOfTheWrongLength) {
  builder_.triangle();
  builder_.add("nodes", {{"name", "n"}, {"mesh", 0}, {"matrix", {1, 2, 3}}});
  expectBad("the matrix of node 0 'n' is not 16 finite numbers");
  builder_.root["nodes"] = {{{"mesh", 0}, {"translation", {1, 2}}}};
  expectBad("the translation of node 0");
}

}  // namespace
}  // namespace enfilade
