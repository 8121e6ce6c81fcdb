#include "scene/gltf_writer.h"

#include <gtest/gtest.h>

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <nlohmann/json.hpp>
#include <random>

#include "gltf_builder.h"
#include "scene/building_repair.h"
#include "scene/gltf_reader.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

Box boundsOf(const Building& building, const Mesh& mesh) {
  Box box;
  for (const std::uint32_t i : mesh.indices) {
    box.extend(building.vertex_arrays[mesh.vertices].positions[i]);
  }
  return box;
}

VertexArrays randomVertices(std::size_t count, bool with_texcoords, bool with_colors) {
  std::mt19937 random(static_cast<std::uint32_t>(count));
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  const auto vec = [&] { return glm::vec3(uniform(random), uniform(random), uniform(random)); };
  VertexArrays vertices;
  for (std::size_t i = 0; i < count; ++i) {
    vertices.positions.push_back(10.0f * vec());
    vertices.normals.push_back(glm::normalize(vec() + glm::vec3(0, 2, 0)));
    if (with_texcoords) vertices.texcoords.emplace_back(vec());
    const auto u16 = [&] { return static_cast<std::uint16_t>(random()); };
    if (with_colors) vertices.colors.emplace_back(u16(), u16(), u16(), u16());
  }
  return vertices;
}

/// Every feature that a building has, its objects in an order that is not that of the nodes.
Building everything() {
  Building building;
  building.name = "the \"house\"";
  building.copyright = "© nobody";
  building.vertex_arrays = {randomVertices(7, true, true), randomVertices(70'000, false, false),
                            randomVertices(5, true, false)};
  building.images.push_back(
      {"as it was", {}, encodePng({2, 1, {1, 2, 3, 4, 5, 6, 7, 8}}), "image/png"});
  building.images.back().image = decodeImage(building.images.back().encoded, "test");
  building.images.push_back({"to be encoded", {1, 1, {9, 8, 7, 6}}, {}, ""});
  building.materials.resize(4);
  building.materials[0] = {.name = "plain", .base_color = {0.1f, 0.2f, 0.3f, 1.0f}};
  building.materials[1] = {.name = "leaves",
                           .image = 0,
                           .wrap_s = Wrap::kClampToEdge,
                           .wrap_t = Wrap::kMirroredRepeat,
                           .nearest_filter = true,
                           .alpha_mode = AlphaMode::kMask,
                           .alpha_cutoff = 0.3f,
                           .double_sided = true};
  building.materials[2] = {.name = "glass",
                           .base_color = {1, 1, 1, 0.25f},
                           .image = 1,
                           .alpha_mode = AlphaMode::kBlend,
                           .unlit = true};
  building.materials[3] = {.name = "", .image = 0};
  building.meshes = {{.name = "a", .vertices = 0, .material = 1, .indices = {0, 1, 2, 4, 5, 6}},
                     {.name = "b", .vertices = 0, .material = 3, .indices = {2, 3, 4}},
                     {.name = "large", .vertices = 1, .material = 0, .indices = {0, 69'999, 5}},
                     {.name = "not placed", .vertices = 2, .material = 0, .indices = {0, 1, 2}},
                     {.name = "a", .vertices = 0, .material = 2, .indices = {1, 5, 3}}};
  for (Mesh& mesh : building.meshes) mesh.bounds = boundsOf(building, mesh);
  const glm::mat4 turned = glm::rotate(glm::translate(glm::mat4(1), {3, 4, 5}), 0.7f,
                                       glm::normalize(glm::vec3(1, 2, 3)));
  building.nodes = {
      {.name = "hall-room", .extras = R"({"cell":"hall","n":[1,null,{}]})"},
      {.name = "turned", .parent = 0, .world_from_node = turned},
      {.name = "mirrored", .parent = 1, .world_from_node = glm::scale(turned, {-1, 2, 0.1f})},
      {.name = "", .parent = 1, .world_from_node = turned},
      {.name = "alone", .world_from_node = glm::translate(glm::mat4(1), {0, 7, 0})}};
  building.objects = {{4, 2}, {1, 0}, {2, 4}, {1, 1}, {3, 0}, {2, 0}};
  return building;
}

void expectSame(const VertexArrays& a, const VertexArrays& b) {
  EXPECT_EQ(a.positions, b.positions);
  EXPECT_EQ(a.normals, b.normals);
  EXPECT_EQ(a.texcoords, b.texcoords);
  EXPECT_EQ(a.colors, b.colors);
}

void expectSame(const Material& a, const Material& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.base_color, b.base_color);
  EXPECT_EQ(a.image, b.image);
  EXPECT_EQ(a.wrap_s, b.wrap_s);
  EXPECT_EQ(a.wrap_t, b.wrap_t);
  EXPECT_EQ(a.nearest_filter, b.nearest_filter);
  EXPECT_EQ(a.alpha_mode, b.alpha_mode);
  EXPECT_EQ(a.double_sided, b.double_sided);
  EXPECT_EQ(a.unlit, b.unlit);
  if (a.alpha_mode == AlphaMode::kMask) {
    EXPECT_EQ(a.alpha_cutoff, b.alpha_cutoff);
  }
}

TEST(GltfWriter, WhatItWritesReadsAsTheSameBuilding) {
  const Building a = everything();
  const TempFolder folder;
  writeGlb(folder / "house.glb", a);
  Warnings warnings;
  const Building b = readGltf(folder / "house.glb", &warnings);
  EXPECT_TRUE(warnings.empty()) << warnings[0];

  EXPECT_EQ(b.name, a.name);
  EXPECT_EQ(b.copyright, a.copyright);
  ASSERT_EQ(b.nodes.size(), a.nodes.size());
  for (std::size_t n = 0; n < a.nodes.size(); ++n) {
    EXPECT_EQ(b.nodes[n].name, a.nodes[n].name);
    EXPECT_EQ(b.nodes[n].parent, a.nodes[n].parent);
    EXPECT_EQ(b.nodes[n].world_from_node, a.nodes[n].world_from_node) << n;
    EXPECT_EQ(b.nodes[n].extras, a.nodes[n].extras);
  }
  ASSERT_EQ(b.objects.size(), a.objects.size());
  for (std::size_t o = 0; o < a.objects.size(); ++o) {
    const Mesh& mesh_a = a.meshOf(a.objects[o]);
    const Mesh& mesh_b = b.meshOf(b.objects[o]);
    EXPECT_EQ(b.objects[o].node, a.objects[o].node) << o;
    EXPECT_EQ(mesh_b.name, mesh_a.name) << o;
    EXPECT_EQ(mesh_b.indices, mesh_a.indices) << o;
    EXPECT_EQ(mesh_b.material, mesh_a.material) << o;
    EXPECT_EQ(mesh_b.bounds.min, mesh_a.bounds.min) << o;
    EXPECT_EQ(mesh_b.bounds.max, mesh_a.bounds.max) << o;
    expectSame(b.vertex_arrays[mesh_b.vertices], a.vertex_arrays[mesh_a.vertices]);
  }
  EXPECT_EQ(b.vertex_arrays.size(), 2u) << "shared, and none that is not used";
  EXPECT_EQ(b.meshes.size(), 4u) << "shared between the glTF meshes that list them";
  ASSERT_EQ(b.materials.size(), a.materials.size());
  for (std::size_t m = 0; m < a.materials.size(); ++m) expectSame(b.materials[m], a.materials[m]);
  ASSERT_EQ(b.images.size(), 2u);
  EXPECT_EQ(b.images[0].encoded, a.images[0].encoded);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(b.images[i].name, a.images[i].name);
    EXPECT_EQ(b.images[i].image.rgba, a.images[i].image.rgba);
  }
}

TEST(GltfWriter, WritesTheSameBytesEveryTimeAndAfterReading) {
  const std::vector<std::uint8_t> bytes = encodeGlb(everything());
  EXPECT_EQ(encodeGlb(everything()), bytes);
  const TempFolder folder;
  const Building once = readGltf(folder.file("a.glb", bytes));
  const std::vector<std::uint8_t> again = encodeGlb(once);
  EXPECT_EQ(encodeGlb(readGltf(folder.file("b.glb", again))), again);
}

TEST(GltfWriter, KeepsTransformsThroughDeepHierarchies) {
  Building building;
  building.vertex_arrays = {randomVertices(3, false, false)};
  building.materials.resize(1);
  building.meshes = {{.name = "m", .vertices = 0, .indices = {0, 1, 2}}};
  std::mt19937 random(3);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  glm::mat4 world(1);
  for (std::uint32_t n = 0; n < 40; ++n) {
    world = glm::translate(world, 20.0f * glm::vec3(uniform(random), uniform(random), 1));
    world =
        glm::rotate(world, uniform(random), glm::normalize(glm::vec3(uniform(random), 1, 0.5f)));
    // Every other node stands upright: its zeros must come back as zeros.
    const glm::mat4 upright = glm::translate(glm::mat4(1), {0, n, 0});
    building.nodes.push_back({.name = std::to_string(n),
                              .parent = n == 0 ? kNone : n - 1,
                              .world_from_node = n % 2 == 0 ? world : upright});
    building.objects.push_back({n, 0});
  }
  const TempFolder folder;
  const Building back = readGltf(folder.file("a.glb", encodeGlb(building)));
  for (std::size_t n = 0; n < building.nodes.size(); ++n) {
    EXPECT_EQ(back.nodes[n].world_from_node, building.nodes[n].world_from_node) << n;
    EXPECT_EQ(back.nodes[n].parent, building.nodes[n].parent);
  }
}

TEST(GltfWriter, LeavesAChildOfAFlattenedNodeWhereItIs) {
  Building building = everything();
  building.nodes[1].world_from_node = glm::scale(glm::mat4(1), {1, 0, 1});
  const TempFolder folder;
  const Building back = readGltf(folder.file("a.glb", encodeGlb(building)));
  for (std::size_t n = 0; n < building.nodes.size(); ++n) {
    EXPECT_EQ(back.nodes[n].world_from_node, building.nodes[n].world_from_node) << n;
  }
}

TEST(GltfWriter, WritesABuildingOfMarkersAlone) {
  Building building;
  building.nodes = {{.name = "marker"}};
  const TempFolder folder;
  const std::string file = folder.file("a.glb", encodeGlb(building));
  expectError([&] { readGltf(file); }, ErrorKind::kBadInput, file, "holds no triangles");
}

/// What the specification asks for and a lenient reader would not notice.
TEST(GltfWriter, KeepsTheRulesOfTheSpecification) {
  const Building building = everything();
  const std::vector<std::uint8_t> glb = encodeGlb(building);
  const auto u32 = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, &glb[at], 4);
    return value;
  };
  ASSERT_EQ(u32(8), glb.size());
  EXPECT_EQ(u32(12) % 4, 0u);
  const Json root = Json::parse(glb.begin() + 20, glb.begin() + 20 + u32(12));
  const std::size_t bin = 20 + u32(12);
  EXPECT_EQ(u32(bin) % 4, 0u);
  EXPECT_EQ(bin + 8 + u32(bin), glb.size());
  EXPECT_EQ(root["buffers"][0]["byteLength"], u32(bin));

  const auto sizeOf = [](const Json& accessor) {
    const std::string type = accessor["type"];
    const int components = type == "SCALAR" ? 1 : type[3] - '0';
    return components * (accessor["componentType"] == kU16 ? 2 : 4);
  };
  for (const Json& accessor : root["accessors"]) {
    const Json& view = root["bufferViews"][accessor["bufferView"].get<std::size_t>()];
    const int offset = accessor["byteOffset"];
    const int stride = view.value("byteStride", sizeOf(accessor));
    EXPECT_EQ(offset % 4, 0);
    EXPECT_EQ(view["byteOffset"].get<int>() % 4, 0);
    EXPECT_GE(stride, sizeOf(accessor));
    EXPECT_LE(offset + stride * (accessor["count"].get<int>() - 1) + sizeOf(accessor),
              view["byteLength"].get<int>());
  }
  int with_colors = 0;
  for (const Json& mesh : root["meshes"]) {
    for (const Json& primitive : mesh["primitives"]) {
      const Json& attributes = primitive["attributes"];
      const auto at = [&](const Json& index) {
        return root["accessors"][index.get<std::size_t>()];
      };
      const Json position = at(attributes["POSITION"]);
      EXPECT_EQ(position["min"].size(), 3u);
      EXPECT_EQ(position["max"].size(), 3u);
      EXPECT_EQ(at(attributes["NORMAL"])["componentType"], kF32);
      if (attributes.contains("TEXCOORD_0")) {
        EXPECT_EQ(at(attributes["TEXCOORD_0"])["type"], "VEC2");
      }
      if (attributes.contains("COLOR_0")) {
        ++with_colors;
        EXPECT_EQ(at(attributes["COLOR_0"])["componentType"], kU16);
        EXPECT_EQ(at(attributes["COLOR_0"])["normalized"], true);
      }
      const Json indices = at(primitive["indices"]);
      EXPECT_FALSE(
          root["bufferViews"][indices["bufferView"].get<std::size_t>()].contains("byteStride"));
    }
  }
  EXPECT_GT(with_colors, 0);
  EXPECT_EQ(root["extensionsUsed"], Json::array({"KHR_materials_unlit"}));
}

TEST(GltfWriter, SharesOneVertexArrayBetweenManyMeshes) {
  Building building;
  building.vertex_arrays = {randomVertices(60'000, false, false)};
  building.materials.resize(1);
  building.nodes.resize(100);
  for (std::uint32_t m = 0; m < 100; ++m) {
    building.meshes.push_back({.name = "part", .vertices = 0, .indices = {m, m + 1, m + 2}});
    building.objects.push_back({m, m});
  }
  const std::vector<std::uint8_t> glb = encodeGlb(building);
  EXPECT_LT(glb.size(), 60'000u * 24 + 100'000);
  const TempFolder folder;
  const Building back = readGltf(folder.file("a.glb", glb));
  EXPECT_EQ(back.vertex_arrays.size(), 1u);
  EXPECT_EQ(back.meshes.size(), 100u);
}

TEST(GltfWriter, WritesNumbersThatManyArraysShareOnce) {
  Building building;
  building.materials.resize(1);
  building.vertex_arrays.assign(2, randomVertices(3, true, true));
  building.vertex_arrays[1].colors[0] = glm::u16vec4(1, 2, 3, 4);
  for (std::uint32_t i = 0; i < 2; ++i) {
    building.meshes.push_back({"mesh", i, 0, {0, 1, 2}, {}});
    building.nodes.push_back({"node", kNone, glm::mat4(1), {}});
    building.objects.push_back({i, i});
  }
  TempFolder folder;
  const std::vector<std::uint8_t> glb = encodeGlb(building);
  const Building again = readGltf(folder.file("model.glb", glb));
  ASSERT_EQ(again.vertex_arrays.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(again.vertex_arrays[i].positions, building.vertex_arrays[i].positions);
    EXPECT_EQ(again.vertex_arrays[i].colors, building.vertex_arrays[i].colors);
  }
  const std::string text(glb.begin(), glb.end());
  std::size_t accessors = 0;
  for (std::size_t at = text.find("componentType"); at != std::string::npos;
       at = text.find("componentType", at + 1)) {
    ++accessors;
  }
  EXPECT_EQ(accessors, 6u) << "positions, normals, texcoords, twice colours, indices";
}

TEST(GltfReader, IgnoresAnOrderOfObjectsThatDoesNotFit) {
  GltfBuilder builder;
  const int mesh = builder.triangle();
  builder.add("nodes", {{"name", "a"}, {"mesh", mesh}});
  builder.add("nodes", {{"name", "b"}, {"mesh", mesh}});
  const TempFolder folder;
  const auto firstName = [&](const Json& order, std::size_t expected_warnings) {
    builder.root["extras"] = {{"enfilade", {{"object_order", order}}}};
    Warnings warnings;
    const Building building = readGltf(folder.file("a.glb", builder.glb()), &warnings);
    EXPECT_EQ(warnings.size(), expected_warnings);
    return building.nodes[building.objects[0].node].name;
  };
  EXPECT_EQ(firstName({1, 0}, 0), "b");
  EXPECT_EQ(firstName({0, 0}, 1), "a");
  EXPECT_EQ(firstName({1, 2}, 1), "a");
  EXPECT_EQ(firstName({1, 0, 1}, 1), "a");
  EXPECT_EQ(firstName({-1, "x"}, 1), "a");
}

}  // namespace
}  // namespace enfilade
