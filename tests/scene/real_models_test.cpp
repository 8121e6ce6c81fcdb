#include <gtest/gtest.h>

#include <filesystem>

#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"

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

INSTANTIATE_TEST_SUITE_P(
    All, RealModels,
    testing::Values(Expected{"duplex.glb", 26684, {9.3f, 8.2f, 26.6f}},
                    Expected{"bimwhale-large.glb", 35474, {53.0f, 8.2f, 39.0f}},
                    Expected{"dream-apartment.glb", 177934, {12.4f, 2.8f, 11.3f}},
                    Expected{"freedoom-e1m1.glb", 3664, {114.0f, 22.0f, 99.0f}}));

}  // namespace
}  // namespace enfilade
