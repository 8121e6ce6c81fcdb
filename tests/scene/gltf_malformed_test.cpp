#include <gtest/gtest.h>

#include <random>

#include "gltf_builder.h"
#include "scene/gltf_reader.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

class MalformedGltf : public testing::Test {
 protected:
  template <typename Content>
  void expectBad(const Content& content, const std::string& words) {
    const std::string file = folder_.file("model.glb", content);
    expectError([&] { readGltf(file); }, ErrorKind::kBadInput, file, words);
  }
  void expectBad(const std::string& words) { expectBad(builder_.glb(), words); }

  /// A whole model: a node with one triangle.
  void triangle() { builder_.add("nodes", {{"mesh", builder_.triangle()}}); }
  Json& accessor(std::size_t i) { return builder_.root["accessors"][i]; }

  GltfBuilder builder_;
  TempFolder folder_;
};

TEST_F(MalformedGltf, MissingFileAndDirectory) {
  expectError([&] { readGltf(folder_ / "none.glb"); }, ErrorKind::kBadInput, folder_ / "none.glb",
              "no such file");
  expectError([&] { readGltf(folder_.path()); }, ErrorKind::kBadInput, folder_.path(),
              "is a directory");
}

TEST_F(MalformedGltf, FilesOfOtherFormatsAreToldApart) {
  expectBad(std::string("hello\nworld"), "neither GLB nor JSON): it begins with \"hello world\"");
  expectBad(std::string("ISO-10303-21;\nHEADER;"), "IFC or STEP");
  expectBad(std::string("PK\x03\x04zip"), "ZIP archive");
  expectBad(std::string("\x01\x02\x03\x04"), "some other binary format");
  expectBad(std::string("version https://git-lfs.github.com/spec/v1"), "git lfs pull");
  expectBad(std::string(), "is empty");
  expectBad(std::string("{\"a\": 1}"), "is JSON but not glTF");
  expectBad(std::string("{\"asset\": {\"version\": "), "is not valid JSON: parse error at line 1");
}

TEST_F(MalformedGltf, EveryTruncationOfAGlbIsNamed) {
  triangle();
  const std::vector<std::uint8_t> whole = builder_.glb();
  for (std::size_t size = 4; size < whole.size(); ++size) {
    const std::vector<std::uint8_t> cut(whole.begin(), whole.begin() + static_cast<long>(size));
    expectBad(cut, "is truncated");
  }
}

TEST_F(MalformedGltf, WrongGlbHeaders) {
  triangle();
  const std::vector<std::uint8_t> whole = builder_.glb();
  auto glb = whole;
  glb[4] = 1;
  expectBad(glb, "GLB of version 1; version 2 is needed");
  glb = whole;
  glb[8] = 3;
  glb[9] = 0;
  expectBad(glb, "length that is too small");
  glb = whole;
  glb[15] = 0x7f;
  expectBad(glb, "is damaged: a chunk says");
  glb = whole;
  glb[16] = 'X';
  expectBad(glb, "its first chunk is not JSON");
}

TEST_F(MalformedGltf, OlderVersionOfGltf) {
  triangle();
  builder_.root["asset"]["version"] = "1.0";
  expectBad("is glTF 1.0; version 2.0 is needed");
}

TEST_F(MalformedGltf, OneThatNeedsANewerVersion) {
  triangle();
  builder_.root["asset"]["minVersion"] = "2.0";
  EXPECT_EQ(triangleCount(readGltf(folder_.file("model.glb", builder_.glb()))), 1u);
  builder_.root["asset"]["version"] = "2.1";
  builder_.root["asset"]["minVersion"] = "2.1";
  expectBad("is glTF 2.1; version 2.0 is needed");
}

TEST_F(MalformedGltf, RequiredExtensionsThatWeLackAreNamed) {
  triangle();
  builder_.root["extensionsRequired"] = {"KHR_texture_transform", "KHR_draco_mesh_compression",
                                         "EXT_meshopt_compression"};
  expectBad("requires the glTF extension KHR_draco_mesh_compression, EXT_meshopt_compression,");
}

TEST_F(MalformedGltf, RequiredExtensionsThatWeHaveAreNoMatter) {
  triangle();
  builder_.root["extensionsRequired"] = {"KHR_texture_transform", "KHR_mesh_quantization",
                                         "KHR_materials_unlit"};
  EXPECT_EQ(triangleCount(readGltf(folder_.file("model.glb", builder_.glb()))), 1u);
}

TEST_F(MalformedGltf, NumbersThatTinygltfWouldTakeForNone) {
  triangle();
  const Json sound = builder_.root;
  const auto refuse = [&](const char* pointer, const Json& value, const std::string& words) {
    builder_.root = sound;
    builder_.root[Json::json_pointer(pointer)] = value;
    expectBad("is no valid glTF: " + words);
  };
  refuse("/accessors/0/byteOffset", -4, "accessors[0].byteOffset is no whole number");
  refuse("/accessors/0/byteOffset", 1.5, "accessors[0].byteOffset is no whole number");
  refuse("/bufferViews/0/byteOffset", -1e30, "bufferViews[0].byteOffset is no whole number");
  refuse("/accessors/0/count", "3", "accessors[0].count is no whole number");
  refuse("/nodes/0/scale", "abc", "nodes[0].scale is no list of numbers");
  refuse("/nodes/0/children", "x", "nodes[0].children is no list of indices");
  refuse("/nodes/0", 7, "nodes[0] is no object");
  refuse("/scene", 0.5, "scene is no index");
  refuse("/meshes/0/primitives/0/material", "red", "meshes[0].primitives[0].material is no index");
  refuse("/materials", {{{"pbrMetallicRoughness", {{"baseColorFactor", "red"}}}}},
         "materials[0].pbrMetallicRoughness.baseColorFactor is no list of numbers");
  builder_.root = sound;
  builder_.root["meshes"][0]["primitives"][0]["material"] = -1;  // as some exporters say none
  EXPECT_EQ(triangleCount(readGltf(folder_.file("model.glb", builder_.glb()))), 1u);
}

TEST_F(MalformedGltf, NoTriangles) {
  builder_.add("nodes", {{"name", "empty"}});
  expectBad("holds no triangles");
  const int positions = builder_.accessor<float>({0, 0, 0, 1, 0, 0}, "VEC3", kF32);
  const int mesh = builder_.mesh({{"attributes", {{"POSITION", positions}}}, {"mode", 1}});
  builder_.add("nodes", {{"mesh", mesh}});
  expectBad("holds no triangles");
}

TEST_F(MalformedGltf, IndexOutOfRange) {
  const int positions = builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", kF32);
  const int indices = builder_.accessor<std::uint8_t>({0, 1, 3}, "SCALAR", kU8);
  const int mesh =
      builder_.mesh({{"attributes", {{"POSITION", positions}}}, {"indices", indices}}, "wall");
  builder_.add("nodes", {{"mesh", mesh}});
  expectBad("mesh 0 'wall' has the index 3 out of range: it has 3 vertices");
}

TEST_F(MalformedGltf, AccessorsThatReachOutside) {
  triangle();
  accessor(0)["count"] = 4;
  expectBad("4 elements reach beyond the end of buffer view 0");
  accessor(0)["count"] = std::uint64_t{1} << 62;
  expectBad("reach beyond the end");
  accessor(0)["count"] = 3;
  accessor(0)["byteOffset"] = 1000;
  expectBad("reach beyond the end");
  accessor(0).erase("byteOffset");
  builder_.root["bufferViews"][0]["byteLength"] = 100'000;
  expectBad("buffer view 0 reaches beyond the end of its buffer");
  builder_.root["bufferViews"][0]["byteLength"] = ~std::uint64_t{0};
  expectBad("buffer view 0 reaches beyond the end of its buffer");
}

TEST_F(MalformedGltf, AccessorsOfTheWrongKind) {
  triangle();
  accessor(0)["type"] = "VEC2";
  expectBad("accessor 0 has 2 components where 3 belong");
  accessor(0)["type"] = "VEC3";
  accessor(0)["componentType"] = 5130;
  expectBad("component type 5130");
  accessor(0)["componentType"] = 5126;
  accessor(0)["bufferView"] = 77;
  expectBad("there is no buffer view 77");
  accessor(0).erase("bufferView");
  accessor(0)["count"] = 1'000'000'000'000;
  expectBad("names over");
}

TEST_F(MalformedGltf, TheSameDataNamedAgainAndAgain) {
  triangle();
  accessor(0).erase("bufferView");
  accessor(0)["count"] = 1 << 20;
  accessor(1).erase("bufferView");
  accessor(1)["count"] = 1 << 20;
  for (std::size_t uv = 0; uv < 3;
       ++uv) {  // each of them is another mesh of the same million vertices
    builder_.add("materials", {{"name", std::to_string(uv)}});
    builder_.root["meshes"][0]["primitives"][uv] = {
        {"attributes", {{"POSITION", 0}, {"NORMAL", 1}, {"COLOR_0", uv}}}, {"material", uv}};
  }
  expectBad("vertices and corners, far more than its 72 bytes hold");
}

TEST_F(MalformedGltf, ObjectsBeyondNumber) {
  triangle();
  const Json primitive = builder_.root["meshes"][0]["primitives"][0];
  builder_.root["meshes"][0]["primitives"] = std::vector<Json>(2100, primitive);
  builder_.root["nodes"] = std::vector<Json>(2100, Json{{"mesh", 0}});
  expectBad("holds over 4194304 objects");
}

TEST_F(MalformedGltf, PlacesBeyondReach) {
  triangle();
  for (const double far : {1e13, 1e300}) {
    builder_.root["nodes"][0]["translation"] = {0, far, 0};
    builder_.root["nodes"][0]["name"] = "moon";
    expectBad("places node 'moon' beyond");
  }
  builder_.root["nodes"][0].erase("translation");
  builder_.root["nodes"][0]["scale"] = {1e30, 1, 1};
  expectBad("places node 'moon' beyond");
}

TEST_F(MalformedGltf, AttributesThatDoNotMatch) {
  triangle();
  const int two = builder_.accessor<float>({0, 0, 1, 0, 0, 1}, "VEC3", kF32);
  builder_.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = two;
  expectBad("mesh 0 'triangle' has 3 positions but 2 of another attribute");
  builder_.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = 99;
  expectBad("there is no accessor 99");
}

TEST_F(MalformedGltf, SparseAccessorsOutOfRange) {
  triangle();
  const int indices = builder_.view<std::uint16_t>({3});
  const int values = builder_.view<float>({0, 0, 0});
  accessor(0)["sparse"] = {{"count", 1},
                           {"indices", {{"bufferView", indices}, {"componentType", kU16}}},
                           {"values", {{"bufferView", values}}}};
  expectBad("a sparse accessor's index is out of range");
  accessor(0)["sparse"]["count"] = 4;
  expectBad("sparse accessor of impossible size");
}

TEST_F(MalformedGltf, JsonThatNestsTooDeep) {
  triangle();
  std::string json = builder_.gltf();
  json.pop_back();
  expectBad(json + ",\"extras\":" + std::string(200'000, '['), "nests its JSON deeper than");
}

TEST_F(MalformedGltf, MembersOfTheWrongType) {
  triangle();
  const Json good = builder_.root;
  for (const auto& [key, value] : good.items()) {
    for (const Json& wrong : {Json("text"), Json(7), Json::array({1, "x", nullptr}), Json(nullptr),
                              Json::array({Json::object()}), Json::object()}) {
      builder_.root = good;
      builder_.root[key] = wrong;
      const std::string file = folder_.file("model.glb", builder_.glb());
      try {
        readGltf(file);
      } catch (const Error& error) {
        EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << key << " = " << wrong;
      }
    }
  }
}

/// Whatever is flipped, the reader gives a building or an Error, and never crashes or hangs.
TEST_F(MalformedGltf, RandomDamageIsEndured) {
  triangle();
  builder_.add("images",
               {{"bufferView", builder_.view(encodePng({2, 2, std::vector<std::uint8_t>(16, 9)}))},
                {"mimeType", "image/png"}});
  builder_.add("textures", {{"source", 0}});
  builder_.add("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  builder_.root["meshes"][0]["primitives"][0]["material"] = 0;
  const std::vector<std::uint8_t> whole = builder_.glb();
  std::mt19937 random(7);
  int survived = 0;
  for (int round = 0; round < 3000; ++round) {
    std::vector<std::uint8_t> damaged = whole;
    for (std::uint32_t flips = 1 + random() % 4; flips > 0; --flips) {
      std::uint8_t& byte = damaged[random() % damaged.size()];
      // Digits become digits, so that the JSON often stays valid and its numbers lie.
      byte = byte >= '0' && byte <= '9' ? static_cast<std::uint8_t>('0' + random() % 10)
                                        : static_cast<std::uint8_t>(random());
    }
    const std::string file = folder_.file("model.glb", damaged);
    try {
      const Building building = readGltf(file);
      ++survived;
      for (const Mesh& mesh : building.meshes) {
        for (const std::uint32_t i : mesh.indices) {
          ASSERT_LT(i, building.vertex_arrays[mesh.vertices].positions.size());
        }
      }
    } catch (const Error& error) {
      ASSERT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
    }
  }
  EXPECT_GT(survived, 100) << "the damage is too heavy to test more than the first check";
  EXPECT_LT(survived, 2900);
}

}  // namespace
}  // namespace enfilade
