// Drawing a subset of the objects must give the same pixels as drawing all of them, wherever the
// subset holds all that is seen: culling rests on it.  What is seen is found by drawing every
// object in a colour of its own.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "render/renderer.h"
#include "scene/gltf_reader.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWidth = 320;
constexpr int kHeight = 256;

/// The same objects, each unlit and of the colour of its number.
Building numbered(const Building& building) {
  Building ids = building;
  ids.meshes.clear();
  ids.materials.clear();
  ids.images.clear();
  for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
    const auto channel = [&](std::uint32_t shift) {
      return std::pow(static_cast<float>((o + 1) >> shift & 255) / 255.0f, 2.2f);
    };
    Material material = unlitMaterial({channel(0), channel(8), channel(16), 1});
    material.double_sided = building.materialOf(building.objects[o]).double_sided;
    ids.materials.push_back(material);
    ids.meshes.push_back(building.meshOf(building.objects[o]));
    ids.meshes.back().material = o;
    ids.objects[o].mesh = o;
  }
  for (VertexArrays& vertices : ids.vertex_arrays) vertices.colors.clear();
  return ids;
}

bool isOpaque(const Building& building, std::uint32_t object) {
  return building.materialOf(building.objects[object]).alpha_mode == AlphaMode::kOpaque;
}

/// The opaque objects that fill a pixel at least, and all that are not opaque.
std::vector<std::uint32_t> seenObjects(const Building& building, Renderer& id_renderer,
                                       const Camera& camera) {
  std::vector<std::uint32_t> opaque;
  std::vector<char> seen(building.objects.size(), 0);
  for (std::uint32_t o = 0; o < seen.size(); ++o) {
    seen[o] = !isOpaque(building, o);
    if (seen[o] == 0) opaque.push_back(o);
  }
  id_renderer.begin(kWidth, kHeight);
  id_renderer.draw(opaque, camera.view());
  Image ids;
  id_renderer.readColor(ids);
  for (std::size_t i = 0; i < ids.rgba.size(); i += 4) {
    const std::size_t id = ids.rgba[i] + 256u * ids.rgba[i + 1] + 65536u * ids.rgba[i + 2];
    if (id >= 1 && id <= seen.size()) seen[id - 1] = 1;
  }
  std::vector<std::uint32_t> objects;
  for (std::uint32_t o = 0; o < seen.size(); ++o) {
    if (seen[o] != 0) objects.push_back(o);
  }
  return objects;
}

struct Frame {
  Image color;
  std::vector<float> depth;
};

Frame frameOf(Renderer& renderer, std::span<const std::uint32_t> objects, const Camera& camera) {
  Frame frame;
  renderer.begin(kWidth, kHeight);
  renderer.draw(objects, camera.view());
  renderer.readColor(frame.color);
  renderer.readDepth(frame.depth);
  return frame;
}

/// Compares at `poses`; returns how many objects were left out in all.
std::size_t expectSubsetsDrawTheSame(const Building& building, std::span<const Pose> poses) {
  Renderer renderer(sharedContext(), building);
  const Building ids = numbered(building);
  Renderer id_renderer(sharedContext(), ids);
  std::size_t left_out = 0;
  for (const Pose& pose : poses) {
    Camera camera = frontCamera(kWidth, kHeight);
    camera.pose = pose;
    const Frame whole = frameOf(renderer, allObjects(building), camera);
    const auto seen = seenObjects(building, id_renderer, camera);
    const Frame subset = frameOf(renderer, seen, camera);
    EXPECT_TRUE(whole.color.rgba == subset.color.rgba) << seen.size() << " objects";
    EXPECT_TRUE(whole.depth == subset.depth) << seen.size() << " objects";
    left_out += building.objects.size() - seen.size();
  }
  return left_out;
}

/// Fans of 1 to 5 triangles of all kinds of material: axis-parallel (so that many coincide or lie
/// in the planes of others) or at random.
Building clutter(std::uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](float low, float high) {
    return low + (high - low) * static_cast<float>(random() & 0xffff) / 65535.0f;
  };
  Building building;
  building.images.push_back({"", checkers(32, 4, {255, 255, 255, 255}, {90, 60, 30, 0}), {}, ""});
  for (int i = 0; i < 300; ++i) {
    Material material;
    material.base_color = {uniform(0, 1), uniform(0, 1), uniform(0, 1), uniform(0.3f, 1)};
    material.double_sided = random() % 2 == 0;
    if (random() % 2 == 0) material.image = 0;
    const auto kind = random() % 10;
    if (kind == 0) material.alpha_mode = AlphaMode::kBlend;
    if (kind == 1) material.alpha_mode = AlphaMode::kMask;
    const glm::vec3 center(std::round(uniform(-4, 4)), std::round(uniform(-4, 4)),
                           std::round(uniform(-12, -2)));
    glm::mat4 transform = glm::translate(glm::mat4(1), center);
    if (random() % 3 == 0) {
      transform = glm::rotate(transform, uniform(0, 6), glm::vec3(0.6f, 0.8f, 0));
    }
    const float half = std::round(uniform(1, 4)) / 2;
    addQuad(building, rectangle(glm::vec2(-half), glm::vec2(half), 0), material, transform);
    std::vector<std::uint32_t>& indices = building.meshes.back().indices;
    for (auto extra = static_cast<std::uint32_t>(random() % 4); extra > 0; --extra) {
      indices.insert(indices.end(), {extra % 4, (extra + 1) % 4, (extra + 2) % 4});
    }
    if (random() % 4 == 0) indices.resize(3);
  }
  return building;
}

TEST(Subset, OfClutterWithCoplanarFacesDrawsTheSamePixels) {
  std::size_t left_out = 0;
  for (const std::uint32_t seed : {1u, 2u, 3u, 4u}) {
    const std::vector<Pose> poses = {Pose{}, poseFromAngles({0, 0, -7}, 1.2f, 0.1f),
                                     poseFromAngles({0.5f, 0.5f, -7}, 3.0f, -0.2f)};
    left_out += expectSubsetsDrawTheSame(clutter(seed), poses);
  }
  EXPECT_GT(left_out, 500u);  // or the comparison would say little
}

void compareModel(const char* name, std::size_t at_least) {
  const std::string file = std::string(ENFILADE_SOURCE_DIR "/../shared/models/") + name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the model " << file << " is not there";
  const Building building = readGltf(file);
  const Box box = worldBounds(building);
  std::mt19937 random(7);
  std::vector<Pose> poses;
  for (int i = 0; i < 12; ++i) {
    glm::vec3 part;
    for (int k = 0; k < 3; ++k) part[k] = static_cast<float>(random() & 0xffff) / 65535.0f;
    const auto quarter = static_cast<float>(i) * 1.5707963f;
    poses.push_back(poseFromAngles(box.min + part * box.size(), i < 4 ? quarter : 6 * part.x,
                                   i < 4 ? 0 : part.y - 0.5f));
  }
  EXPECT_GT(expectSubsetsDrawTheSame(building, poses), at_least);
}

TEST(Subset, OfTheDuplexHouseDrawsTheSamePixels) { compareModel("duplex.glb", 1000); }
TEST(Subset, OfTheGameMapDrawsTheSamePixels) { compareModel("freedoom-e1m1.glb", 2000); }

}  // namespace
}  // namespace enfilade
