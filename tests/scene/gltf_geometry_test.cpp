#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gltf_builder.h"
#include "scene/gltf_reader.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

class GltfGeometry : public testing::Test {
 protected:
  /// Reads what was built, with a node for every mesh.
  Building read() {
    for (int m = 0; m < static_cast<int>(builder_.root["meshes"].size()); ++m) {
      builder_.add("nodes", {{"mesh", m}});
    }
    return readGltf(folder_.file("model.glb", builder_.glb()), &warnings_);
  }
  const VertexArrays& verticesOf(const Building& building, std::size_t object) {
    return building.vertex_arrays[building.meshOf(building.objects[object]).vertices];
  }
  /// The corners of an object's triangles, in the world.
  static std::vector<glm::vec3> cornersOf(const Building& building, std::size_t object) {
    const Mesh& mesh = building.meshOf(building.objects[object]);
    std::vector<glm::vec3> corners;
    for (const std::uint32_t i : mesh.indices) {
      corners.emplace_back(building.worldFromObject(building.objects[object]) *
                           glm::vec4(building.vertex_arrays[mesh.vertices].positions[i], 1));
    }
    return corners;
  }
  bool warned(const std::string& words) const {
    for (const std::string& line : warnings_) {
      if (line.find(words) != std::string::npos) return true;
    }
    return false;
  }

  const std::vector<float> square_{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  GltfBuilder builder_;
  TempFolder folder_;
  Warnings warnings_;
};

TEST_F(GltfGeometry, ReadsIndicesOfEveryType) {
  const int positions = builder_.accessor(square_, "VEC3", kF32);
  const std::vector<int> accessors{
      builder_.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR", kU8),
      builder_.accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, "SCALAR", kU16),
      builder_.accessor<std::uint32_t>({0, 1, 2, 0, 2, 3}, "SCALAR", kU32)};
  for (const int indices : accessors) {
    builder_.mesh(
        {{"attributes", {{"POSITION", positions}, {"NORMAL", positions}}}, {"indices", indices}});
  }
  const Building building = read();
  ASSERT_EQ(building.objects.size(), 3u);
  for (const Object& object : building.objects) {
    EXPECT_EQ(building.meshOf(object).indices, (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
  }
}

TEST_F(GltfGeometry, ReadsPositionsOfEveryComponentTypeThatQuantizationAllows) {
  builder_.root["extensionsRequired"] = {"KHR_mesh_quantization"};
  const auto meshOf = [&](int positions) {
    builder_.mesh({{"attributes", {{"POSITION", positions}}}});
  };
  meshOf(builder_.accessor<std::int8_t>({0, 0, 0, -128, 0, 0, 0, 127, 0}, "VEC3", kI8));
  meshOf(builder_.accessor<std::uint8_t>({0, 0, 0, 255, 0, 0, 0, 1, 0}, "VEC3", kU8));
  meshOf(builder_.accessor<std::int16_t>({0, 0, 0, -32768, 0, 0, 0, 32767, 0}, "VEC3", kI16));
  meshOf(builder_.accessor<std::uint16_t>({0, 0, 0, 65535, 0, 0, 0, 1, 0}, "VEC3", kU16));
  const Json normalized{{"normalized", true}};
  meshOf(builder_.accessor<std::int8_t>({0, 0, 0, -128, 0, 0, 0, 127, 0}, "VEC3", kI8, normalized));
  meshOf(builder_.accessor<std::uint8_t>({0, 0, 0, 255, 0, 0, 0, 51, 0}, "VEC3", kU8, normalized));
  meshOf(builder_.accessor<std::int16_t>({0, 0, 0, -32768, 0, 0, 0, 32767, 0}, "VEC3", kI16,
                                         normalized));
  meshOf(builder_.accessor<std::uint16_t>({0, 0, 0, 65535, 0, 0, 0, 13107, 0}, "VEC3", kU16,
                                          normalized));
  const Building building = read();
  const std::vector<glm::vec2> expected{{-128, 127}, {255, 1},  {-32768, 32767}, {65535, 1},
                                        {-1, 1},     {1, 0.2f}, {-1, 1},         {1, 0.2f}};
  ASSERT_EQ(building.objects.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const std::vector<glm::vec3> corners = cornersOf(building, i);
    EXPECT_EQ(corners[1], glm::vec3(expected[i].x, 0, 0)) << i;
    EXPECT_FLOAT_EQ(corners[2].y, expected[i].y) << i;
  }
}

TEST_F(GltfGeometry, WalksByteStridesAndOffsets) {
  // Position and normal side by side, 24 bytes apart, behind 8 bytes of something else.
  const std::vector<float> interleaved{9, 9, 0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1};
  const int view = builder_.view(interleaved, 24);
  const Json common{{"bufferView", view}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}};
  Json position = common;
  position["byteOffset"] = 8;
  Json normal = common;
  normal["byteOffset"] = 20;
  builder_.mesh({{"attributes",
                  {{"POSITION", builder_.add("accessors", position)},
                   {"NORMAL", builder_.add("accessors", normal)}}}});
  const Building building = read();
  EXPECT_EQ(cornersOf(building, 0), (std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  EXPECT_EQ(verticesOf(building, 0).normals, std::vector<glm::vec3>(3, {0, 0, 1}));
}

TEST_F(GltfGeometry, PutsSparseValuesIn) {
  const int dense = builder_.accessor(square_, "VEC3", kF32);
  const Json sparse{
      {"count", 2},
      {"indices", {{"bufferView", builder_.view<std::uint16_t>({1, 3})}, {"componentType", kU16}}},
      {"values", {{"bufferView", builder_.view<float>({5, 0, 0, 0, 7, 0})}}}};
  builder_.root["accessors"][static_cast<std::size_t>(dense)]["sparse"] = sparse;
  Json zeros{{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}, {"sparse", sparse}};
  const int indices = builder_.accessor<std::uint8_t>({0, 1, 2, 0, 2, 3}, "SCALAR", kU8);
  builder_.mesh({{"attributes", {{"POSITION", dense}}}, {"indices", indices}});
  builder_.mesh(
      {{"attributes", {{"POSITION", builder_.add("accessors", zeros)}}}, {"indices", indices}});
  const Building building = read();
  EXPECT_EQ(
      cornersOf(building, 0),
      (std::vector<glm::vec3>{{0, 0, 0}, {5, 0, 0}, {1, 1, 0}, {0, 0, 0}, {1, 1, 0}, {0, 7, 0}}));
  EXPECT_EQ(cornersOf(building, 1)[1], glm::vec3(5, 0, 0));
  EXPECT_EQ(cornersOf(building, 1)[2], glm::vec3(0, 0, 0));
}

TEST_F(GltfGeometry, TurnsStripsAndFansIntoTrianglesOfTheSameWinding) {
  // A strip zigzags over 2 × 1 squares; a fan goes round the square's corners.
  const int strip = builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0, 2, 0, 1, 2, 0},
                                             "VEC3", kF32);
  const int fan = builder_.accessor(square_, "VEC3", kF32);
  builder_.mesh({{"attributes", {{"POSITION", strip}}}, {"mode", 5}});
  builder_.mesh({{"attributes", {{"POSITION", fan}}}, {"mode", 6}});
  const Building building = read();
  ASSERT_EQ(building.objects.size(), 2u);
  float area[2] = {0, 0};
  for (std::size_t o = 0; o < 2; ++o) {
    const std::vector<glm::vec3> corners = cornersOf(building, o);
    for (std::size_t i = 0; i < corners.size(); i += 3) {
      const glm::vec3 normal = glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
      EXPECT_GT(normal.z, 0.0f) << "object " << o << " triangle " << i / 3;
      area[o] += 0.5f * normal.z;
    }
  }
  EXPECT_FLOAT_EQ(area[0], 2.0f);
  EXPECT_FLOAT_EQ(area[1], 1.0f);
}

TEST_F(GltfGeometry, LeavesPointsAndLinesOutAndSaysSo) {
  builder_.triangle();
  const int positions = builder_.accessor(square_, "VEC3", kF32);
  for (const int mode : {0, 1, 2, 3}) {
    builder_.mesh({{"attributes", {{"POSITION", positions}}}, {"mode", mode}}, "wire");
  }
  EXPECT_EQ(read().objects.size(), 1u);
  EXPECT_TRUE(warned("points or lines left out: mesh 1 'wire' and 3 more"));
}

TEST_F(GltfGeometry, GivesFlatNormalsToWhatHasNone) {
  // Two triangles that share an edge and stand at a right angle.
  const int positions =
      builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, "VEC3", kF32);
  const int indices = builder_.accessor<std::uint8_t>({0, 1, 2, 0, 3, 1}, "SCALAR", kU8);
  builder_.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}});
  const Building building = read();
  const VertexArrays& vertices = verticesOf(building, 0);
  const Mesh& mesh = building.meshOf(building.objects[0]);
  ASSERT_EQ(vertices.normals.size(), vertices.positions.size());
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(vertices.normals[mesh.indices[i]], i < 3 ? glm::vec3(0, 0, 1) : glm::vec3(0, 1, 0));
  }
  EXPECT_EQ(building.vertex_arrays.size(), 1u) << "the arrays without normals must not stay";
}

TEST_F(GltfGeometry, MakesNormalsUnitAndComputesThoseWithoutADirection) {
  const int positions = builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 0, -1}, "VEC3", kF32);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const int normals = builder_.accessor<float>({0, 0, 8, 0, 0, 0, nan, 1, 0}, "VEC3", kF32);
  builder_.mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}});
  const Building building = read();
  const std::vector<glm::vec3>& n = verticesOf(building, 0).normals;
  EXPECT_EQ(n, (std::vector<glm::vec3>{{0, 0, 1}, {0, 1, 0}, {0, 1, 0}}));
  EXPECT_TRUE(warned("normals without a direction, computed: 2 vertices"));
}

TEST_F(GltfGeometry, LeavesOutTrianglesWithACornerThatIsNotFinite) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float inf = std::numeric_limits<float>::infinity();
  const int positions =
      builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0, nan, 0, 0, 0, inf, 0}, "VEC3", kF32);
  const int indices = builder_.accessor<std::uint8_t>({0, 1, 3, 0, 1, 2, 4, 1, 2}, "SCALAR", kU8);
  builder_.mesh(
      {{"attributes", {{"POSITION", positions}, {"NORMAL", positions}}}, {"indices", indices}});
  const Building building = read();
  EXPECT_EQ(building.meshOf(building.objects[0]).indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_TRUE(warned("no number within 1e12 m"));
  for (const glm::vec3& p : verticesOf(building, 0).positions) {
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
  }
  EXPECT_EQ(building.meshes[0].bounds.max, glm::vec3(1, 1, 0));
}

TEST_F(GltfGeometry, ReadsVertexColoursOfEveryForm) {
  const int positions = builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", kF32);
  const Json normalized{{"normalized", true}};
  const std::vector<int> colors{
      builder_.accessor<float>({0, 0.5f, 1, 0, 0.5f, 1, -1, 0.5f, 2}, "VEC3", kF32),
      builder_.accessor<float>({0, 0.5f, 1, 0.25f, 0, 0.5f, 1, 0.25f, 0, 0.5f, 1, 0.25f}, "VEC4",
                               kF32),
      builder_.accessor<std::uint8_t>({0, 128, 255, 64, 0, 128, 255, 64, 0, 128, 255, 64}, "VEC4",
                                      kU8, normalized),
      builder_.accessor<std::uint16_t>({0, 32768, 65535, 0, 32768, 65535, 0, 32768, 65535}, "VEC3",
                                       kU16, normalized)};
  for (const int color : colors) {
    builder_.mesh({{"attributes", {{"POSITION", positions}, {"COLOR_0", color}}}});
  }
  const Building building = read();
  const auto half = static_cast<std::uint16_t>(32768);
  const auto quarter = static_cast<std::uint16_t>(16384);
  const std::vector<glm::u16vec4> expected{{0, half, 65535, 65535},
                                           {0, half, 65535, quarter},
                                           {0, 128 * 257, 65535, 64 * 257},
                                           {0, half, 65535, 65535}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(verticesOf(building, i).colors.size(), 3u);
    for (const glm::u16vec4& c : verticesOf(building, i).colors) EXPECT_EQ(c, expected[i]) << i;
  }
}

TEST_F(GltfGeometry, SharesVerticesBetweenPrimitivesThatNameTheSameAccessors) {
  const int positions = builder_.accessor(square_, "VEC3", kF32);
  const int normals = builder_.accessor<float>(std::vector<float>(12, 1.0f), "VEC3", kF32);
  const Json attributes{{"POSITION", positions}, {"NORMAL", normals}};
  const int a = builder_.accessor<std::uint8_t>({0, 1, 2}, "SCALAR", kU8);
  const int b = builder_.accessor<std::uint8_t>({0, 2, 3}, "SCALAR", kU8);
  builder_.mesh({{"attributes", attributes}, {"indices", a}});
  builder_.mesh({{"attributes", attributes}, {"indices", b}});
  builder_.mesh({{"attributes", attributes}, {"indices", a}});
  const Building building = read();
  EXPECT_EQ(building.vertex_arrays.size(), 1u);
  EXPECT_EQ(building.meshes.size(), 2u) << "the third mesh is the first";
  EXPECT_EQ(building.objects.size(), 3u);
  EXPECT_EQ(building.meshes[1].bounds.max, glm::vec3(1, 1, 0));
}

TEST_F(GltfGeometry, KeepsAMeshOfManyNodesShared) {
  const int mesh = builder_.triangle();
  for (int i = 0; i < 4; ++i) builder_.add("nodes", {{"mesh", mesh}, {"translation", {i, 0, 0}}});
  const Building building = read();
  EXPECT_EQ(building.objects.size(), 5u);
  EXPECT_EQ(building.meshes.size(), 1u);
  EXPECT_EQ(triangleCount(building), 5u);
  EXPECT_EQ(worldBounds(building).max.x, 4.0f);
}

}  // namespace
}  // namespace enfilade
