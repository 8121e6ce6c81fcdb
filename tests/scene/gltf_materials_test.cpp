#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "gltf_builder.h"
#include "scene/gltf_reader.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

std::vector<std::uint8_t> picture(std::uint8_t red) { return encodePng({1, 1, {red, 0, 0, 255}}); }

class GltfMaterials : public testing::Test {
 protected:
  GltfMaterials() {
    positions_ = builder_.accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", kF32);
    uv0_ = builder_.accessor<float>({0, 0, 1, 0, 0, 1}, "VEC2", kF32);
    uv1_ = builder_.accessor<float>({0.5f, 0.5f, 0.25f, 0.5f, 0.5f, 0.25f}, "VEC2", kF32);
    builder_.root["scenes"] = Json::array({Json::object()});
  }
  /// A triangle of this material on a node of its own.
  void place(const Json& material) {
    const int index = builder_.add("materials", material);
    const int mesh = builder_.mesh(
        {{"attributes", {{"POSITION", positions_}, {"TEXCOORD_0", uv0_}, {"TEXCOORD_1", uv1_}}},
         {"material", index}});
    builder_.root["scenes"][0]["nodes"].push_back(builder_.add("nodes", {{"mesh", mesh}}));
  }
  static Json textured(int texture, const Json& more = Json::object()) {
    Json info{{"index", texture}};
    info.update(more);
    return {{"pbrMetallicRoughness", {{"baseColorTexture", info}}}};
  }
  /// An image in the binary chunk and a texture of it.
  int texture(std::uint8_t red, const Json& more = Json::object()) {
    Json json{{"source", builder_.add("images", {{"bufferView", builder_.view(picture(red))},
                                                 {"mimeType", "image/png"},
                                                 {"name", "red " + std::to_string(red)}})}};
    json.update(more);
    return builder_.add("textures", json);
  }
  Building read() { return readGltf(folder_.file("model.glb", builder_.glb()), &warnings_); }
  std::vector<glm::vec2> texcoordsOf(const Building& building, std::size_t object) {
    return building.vertex_arrays[building.meshOf(building.objects[object]).vertices].texcoords;
  }

  GltfBuilder builder_;
  TempFolder folder_;
  Warnings warnings_;
  int positions_ = 0;
  int uv0_ = 0;
  int uv1_ = 0;
};

TEST_F(GltfMaterials, WithPicturesOfGigabytesInOnePartOfTheFileAreRefused) {
  const std::vector<std::uint8_t> grey(std::size_t{4} * 2048 * 2048, 128);
  const int view = builder_.view(encodePng({2048, 2048, grey}));
  for (int i = 0; i < 60; ++i) {
    const int image = builder_.add("images", {{"bufferView", view}, {"mimeType", "image/png"}});
    place(textured(builder_.add("textures", {{"source", image}})));
  }
  const std::string file = folder_.file("model.glb", builder_.glb());
  expectError([&] { readGltf(file); }, ErrorKind::kBadInput, file,
              "pixels, far more than its bytes can hold");
}

TEST_F(GltfMaterials, HaveTheirFactorsModesAndSides) {
  place({{"name", "glass"},
         {"pbrMetallicRoughness", {{"baseColorFactor", {0.25, 0.5, 0.75, 0.125}}}},
         {"alphaMode", "BLEND"},
         {"doubleSided", true}});
  place({{"alphaMode", "MASK"}, {"alphaCutoff", 0.25}});
  place({{"alphaMode", "MASK"}});
  place({{"extensions", {{"KHR_materials_unlit", Json::object()}}}});
  const Building building = read();
  ASSERT_EQ(building.materials.size(), 4u);
  const Material& glass = building.materials[0];
  EXPECT_EQ(glass.name, "glass");
  EXPECT_EQ(glass.base_color, glm::vec4(0.25f, 0.5f, 0.75f, 0.125f));
  EXPECT_EQ(glass.alpha_mode, AlphaMode::kBlend);
  EXPECT_TRUE(glass.double_sided);
  EXPECT_FALSE(glass.unlit);
  EXPECT_EQ(building.materials[1].alpha_mode, AlphaMode::kMask);
  EXPECT_EQ(building.materials[1].alpha_cutoff, 0.25f);
  EXPECT_EQ(building.materials[2].alpha_cutoff, 0.5f);
  EXPECT_EQ(building.materials[3].alpha_mode, AlphaMode::kOpaque);
  EXPECT_TRUE(building.materials[3].unlit);
  EXPECT_EQ(building.materials[3].base_color, glm::vec4(1));
}

TEST_F(GltfMaterials, AreWhiteAndOpaqueWhereAPrimitiveNamesNone) {
  const int mesh = builder_.mesh({{"attributes", {{"POSITION", positions_}}}});
  builder_.root["scenes"][0]["nodes"].push_back(builder_.add("nodes", {{"mesh", mesh}}));
  const Building building = read();
  const Material& material = building.materialOf(building.objects[0]);
  EXPECT_EQ(material.base_color, glm::vec4(1));
  EXPECT_EQ(material.image, kNone);
  EXPECT_FALSE(material.double_sided);
}

TEST_F(GltfMaterials, ShareAPictureAndKeepItsBytes) {
  const int a = texture(10);
  const int b = texture(20);
  place(textured(b));
  place(textured(a));
  place(textured(b));
  const Building building = read();
  ASSERT_EQ(building.images.size(), 2u) << "in the file's order";
  EXPECT_EQ(building.images[0].name, "red 10");
  EXPECT_EQ(building.images[0].encoded, picture(10));
  EXPECT_EQ(building.images[0].mime_type, "image/png");
  EXPECT_EQ(building.images[1].image.rgba, (std::vector<std::uint8_t>{20, 0, 0, 255}));
  EXPECT_EQ(building.materials[0].image, 1u);
  EXPECT_EQ(building.materials[1].image, 0u);
  EXPECT_EQ(building.materials[2].image, 1u);
}

TEST_F(GltfMaterials, TakeWrapAndFilterFromTheSampler) {
  builder_.add("samplers", {{"wrapS", 33071}, {"wrapT", 33648}, {"magFilter", 9728}});
  place(textured(texture(10, {{"sampler", 0}})));
  place(textured(texture(10)));
  const Building building = read();
  EXPECT_EQ(building.materials[0].wrap_s, Wrap::kClampToEdge);
  EXPECT_EQ(building.materials[0].wrap_t, Wrap::kMirroredRepeat);
  EXPECT_TRUE(building.materials[0].nearest_filter);
  EXPECT_EQ(building.materials[1].wrap_s, Wrap::kRepeat);
  EXPECT_FALSE(building.materials[1].nearest_filter);
}

TEST_F(GltfMaterials, SampleByTheTextureCoordinatesThatTheyName) {
  const int t = texture(10);
  place(textured(t, {{"texCoord", 1}}));
  place(textured(t));
  const Building building = read();
  EXPECT_EQ(texcoordsOf(building, 0),
            (std::vector<glm::vec2>{{0.5f, 0.5f}, {0.25f, 0.5f}, {0.5f, 0.25f}}));
  EXPECT_EQ(texcoordsOf(building, 1), (std::vector<glm::vec2>{{0, 0}, {1, 0}, {0, 1}}));
}

TEST_F(GltfMaterials, HaveTheirTextureTransformBakedIn) {
  const int t = texture(10);
  const auto transformed = [&](const Json& transform) {
    place(textured(t, {{"extensions", {{"KHR_texture_transform", transform}}}}));
  };
  transformed({{"offset", {0.25, 0.5}}, {"scale", {2, 3}}});
  transformed({{"texCoord", 1}});
  // A quarter turn counter-clockwise on screen, v pointing down: u goes up (−v), v goes right (+u).
  transformed({{"rotation", glm::half_pi<double>()}});
  // The order is scale, then rotation, then offset.
  transformed({{"offset", {10, 20}}, {"rotation", glm::half_pi<double>()}, {"scale", {2, 3}}});
  const Building building = read();
  const auto expectNear = [&](std::size_t object, const std::vector<glm::vec2>& expected) {
    const std::vector<glm::vec2> texcoords = texcoordsOf(building, object);
    ASSERT_EQ(texcoords.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(texcoords[i].x, expected[i].x, 1e-6f) << object << ", " << i;
      EXPECT_NEAR(texcoords[i].y, expected[i].y, 1e-6f) << object << ", " << i;
    }
  };
  expectNear(0, {{0.25f, 0.5f}, {2.25f, 0.5f}, {0.25f, 3.5f}});
  expectNear(1, {{0.5f, 0.5f}, {0.25f, 0.5f}, {0.5f, 0.25f}});
  expectNear(2, {{0, 0}, {0, -1}, {1, 0}});
  expectNear(3, {{10, 20}, {10, 18}, {13, 20}});
}

TEST_F(GltfMaterials, OfSpecularAndGlossHaveTheirDiffuseColour) {
  const Json transform{{"KHR_texture_transform", {{"offset", {3, 4}}}}};
  place({{"extensions",
          {{"KHR_materials_pbrSpecularGlossiness",
            {{"diffuseFactor", {0.5, 0.25, 0.125, 1}},
             {"diffuseTexture",
              {{"index", texture(10)}, {"texCoord", 1}, {"extensions", transform}}}}}}}});
  place({{"extensions", {{"KHR_materials_pbrSpecularGlossiness", Json::object()}}}});
  const Building building = read();
  EXPECT_EQ(building.materials[0].base_color, glm::vec4(0.5f, 0.25f, 0.125f, 1));
  EXPECT_EQ(building.materials[0].image, 0u);
  EXPECT_EQ(texcoordsOf(building, 0)[0], glm::vec2(3.5f, 4.5f));
  EXPECT_EQ(building.materials[1].base_color, glm::vec4(1));
}

TEST_F(GltfMaterials, WithAPictureAlwaysComeWithTextureCoordinates) {
  place(textured(texture(10)));
  builder_.root["meshes"][0]["primitives"][0]["attributes"] = {{"POSITION", positions_}};
  EXPECT_EQ(texcoordsOf(read(), 0), std::vector<glm::vec2>(3, glm::vec2(0)));
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_EQ(warnings_[0], "picture without texture coordinates: mesh 'mesh'");
}

TEST_F(GltfMaterials, GoWithoutAPictureThatCannotBeDecoded) {
  std::vector<std::uint8_t> damaged = picture(10);
  damaged.resize(30);
  const int image = builder_.add(
      "images",
      {{"bufferView", builder_.view(damaged)}, {"mimeType", "image/png"}, {"name", "wallpaper"}});
  place(textured(builder_.add("textures", {{"source", image}})));
  const Building building = read();
  EXPECT_EQ(building.materials[0].image, kNone);
  EXPECT_TRUE(building.images.empty());
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(warnings_[0].starts_with("picture left out: image 0 'wallpaper'")) << warnings_[0];
}

TEST_F(GltfMaterials, GoWithoutAPictureOfAnotherFormat) {
  place(textured(
      builder_.add("textures", {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}})));
  EXPECT_EQ(read().materials[0].image, kNone);
  ASSERT_EQ(warnings_.size(), 1u);
  EXPECT_TRUE(warnings_[0].starts_with("picture neither PNG nor JPEG")) << warnings_[0];
}

TEST_F(GltfMaterials, RejectIndicesOfWhatIsNotThere) {
  const auto expectBad = [&](const std::string& words) {
    const std::string file = folder_.file("model.glb", builder_.glb());
    expectError([&] { readGltf(file); }, ErrorKind::kBadInput, file, words);
  };
  place(textured(5));
  expectBad("there is no texture 5");
  builder_.add("textures", {{"source", 9}});
  builder_.root["materials"][0] = textured(0);
  expectBad("there is no image 9");
  builder_.root["meshes"][0]["primitives"][0]["material"] = 4;
  builder_.root["materials"][0] = Json::object();
  expectBad("there is no material 4");
}

}  // namespace
}  // namespace enfilade
