#include <gtest/gtest.h>

#include <filesystem>

#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

struct Expected {
  const char* file;
  std::size_t triangles;
  glm::vec3 size;  ///< [m]
};

class RealModels : public testing::TestWithParam<Expected> {
 protected:
  void SetUp() override {
    file_ = std::string(ENFILADE_SOURCE_DIR "/../shared/models/") + GetParam().file;
    if (!std::filesystem::exists(file_)) GTEST_SKIP() << "the real buildings are not here";
  }
  std::string file_;
};

TEST_P(RealModels, HaveTheTrianglesAndTheSizeThatTheirReadmeStates) {
  const Building building = readGltf(file_);
  EXPECT_EQ(triangleCount(building), GetParam().triangles);
  const glm::vec3 size = worldBounds(building).size();
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(size[i], GetParam().size[i], 0.5f) << "axis " << i;
}

TEST_P(RealModels, AreTheSameAfterWritingAndReading) {
  const Building a = readGltf(file_);
  const TempFolder folder;
  const std::vector<std::uint8_t> bytes = encodeGlb(a);
  const Building b = readGltf(folder.file("copy.glb", bytes));
  EXPECT_EQ(encodeGlb(b), bytes);
  ASSERT_EQ(b.nodes.size(), a.nodes.size());
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    EXPECT_EQ(b.nodes[n].name, a.nodes[n].name);
    EXPECT_EQ(b.nodes[n].world_from_node, a.nodes[n].world_from_node) << n;
  }
  ASSERT_EQ(b.objects.size(), a.objects.size());
  for (std::size_t o = 0; o < a.objects.size(); ++o) {
    EXPECT_EQ(b.objects[o].node, a.objects[o].node);
    EXPECT_EQ(b.meshOf(b.objects[o]).indices, a.meshOf(a.objects[o]).indices);
    EXPECT_EQ(b.vertex_arrays[b.meshOf(b.objects[o]).vertices].positions,
              a.vertex_arrays[a.meshOf(a.objects[o]).vertices].positions);
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, RealModels,
    testing::Values(Expected{"duplex.glb", 26684, {9.3f, 8.2f, 26.6f}},
                    Expected{"bimwhale-large.glb", 35474, {53.0f, 8.2f, 39.0f}},
                    Expected{"dream-apartment.glb", 177934, {12.4f, 2.8f, 11.3f}},
                    Expected{"freedoom-e1m1.glb", 3664, {114.0f, 22.0f, 99.0f}}));

}  // namespace
}  // namespace enfilade
