// The renderer without its sieve is the oracle: the same pixels and depths, to the last bit, and
// no triangle left out that by itself would draw a pixel.

#include "render/triangle_sieve.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <filesystem>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "render/renderer.h"
#include "scene/gltf_reader.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWidth = 160;
constexpr int kHeight = 128;

struct Frame {
  Image color;
  std::vector<float> depth;
  std::size_t triangles = 0;
};

Frame frameOf(Renderer& renderer, const Building& building, const View& view, bool sifting) {
  Frame frame;
  renderer.setSifting(sifting);
  renderer.begin(kWidth, kHeight);
  frame.triangles = renderer.draw(allObjects(building), view).triangles;
  renderer.readColor(frame.color);
  renderer.readDepth(frame.depth);
  return frame;
}

/// Compares; returns the share of the triangles that the sieve left in.
double expectTheSame(Renderer& renderer, const Building& building, const View& view) {
  const Frame all = frameOf(renderer, building, view, false);
  const Frame sifted = frameOf(renderer, building, view, true);
  EXPECT_TRUE(all.color.rgba == sifted.color.rgba) << sifted.triangles << " triangles";
  EXPECT_TRUE(all.depth == sifted.depth) << sifted.triangles << " triangles";
  return static_cast<double>(sifted.triangles) / static_cast<double>(all.triangles);
}

/// Random numbers that are the same everywhere.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  float uniform(float low, float high) {
    return low + (high - low) * static_cast<float>(random_() & 0xffff) / 65535.0f;
  }
  glm::vec3 in(const glm::vec3& half) {
    return {uniform(-half.x, half.x), uniform(-half.y, half.y), uniform(-half.z, half.z)};
  }
  bool oneIn(std::uint32_t n) { return random_() % n == 0; }

 private:
  std::mt19937 random_;
};

/// Adds triangles as an object.
void addTriangles(Building& building, std::vector<glm::vec3> corners, const Material& material,
                  const glm::mat4& world_from_object = glm::mat4(1)) {
  addQuad(building, rectangle({0, 0}, {1, 1}, 0), material, world_from_object);
  VertexArrays& vertices = building.vertex_arrays.back();
  vertices.normals.assign(corners.size(), {0, 0, 1});
  vertices.texcoords.assign(corners.size(), {0.5f, 0.5f});
  Mesh& mesh = building.meshes.back();
  mesh.indices.resize(corners.size());
  std::iota(mesh.indices.begin(), mesh.indices.end(), 0u);
  mesh.bounds = {};
  for (const glm::vec3& corner : corners) mesh.bounds.extend(corner);
  vertices.positions = std::move(corners);
}

Material anyMaterial(Dice& dice) {
  Material material;
  material.base_color = {dice.uniform(0, 1), dice.uniform(0, 1), dice.uniform(0, 1), 0.6f};
  material.double_sided = dice.oneIn(3);
  if (dice.oneIn(5)) material.alpha_mode = AlphaMode::kMask;
  if (dice.oneIn(8)) material.alpha_mode = AlphaMode::kBlend;
  if (dice.oneIn(2)) material.image = 0;
  return material;
}

/// Walls of all kinds of material with gravel about them: triangles of a fraction of a pixel to a
/// few, slivers, triangles that reach behind the eye; some objects mirrored.
Building gravel(std::uint32_t seed) {
  Dice dice(seed);
  Building building;
  building.images.push_back({"", checkers(32, 4, {255, 255, 255, 255}, {90, 60, 30, 0}), {}, ""});
  for (int i = 0; i < 30; ++i) {
    glm::mat4 transform = glm::translate(glm::mat4(1), glm::round(dice.in({4, 4, 6})));
    transform = glm::rotate(transform, 1.5707963f * std::round(dice.uniform(0, 4)), {0, 1, 0});
    if (dice.oneIn(3)) transform = glm::rotate(transform, dice.uniform(0, 6), {0.6f, 0.8f, 0});
    if (dice.oneIn(4)) transform = glm::scale(transform, {-1, 1, 1});
    const float half = std::round(dice.uniform(1, 6)) / 2;
    addQuad(building, rectangle(glm::vec2(-half), glm::vec2(half), 0), anyMaterial(dice),
            transform);
  }
  for (int i = 0; i < 30; ++i) {
    std::vector<glm::vec3> corners;
    const float size = std::pow(10.0f, dice.uniform(-2.5f, 0.5f));
    for (int t = 0; t < 200; ++t) {
      const glm::vec3 at = dice.in({5, 5, 7});
      const glm::vec3 along = dice.in(glm::vec3(size));
      const bool sliver = dice.oneIn(4);
      corners.insert(
          corners.end(),
          {at, at + along, at + 0.4f * along + dice.in(glm::vec3(sliver ? 1e-4f : size))});
    }
    const bool mirrored = dice.oneIn(3);
    addTriangles(building, corners, anyMaterial(dice),
                 glm::scale(glm::mat4(1), glm::vec3(mirrored ? -1 : 1, 1, 1)));
  }
  return building;
}

Camera anyCamera(Dice& dice, const Box& box) {
  Camera camera = frontCamera(kWidth, kHeight);
  camera.near_plane = 0.05f;
  const glm::vec3 half = 0.5f * box.size();
  camera.pose = poseFromAngles(box.center() + dice.in(half), dice.uniform(-3.2f, 3.2f),
                               dice.uniform(-0.8f, 0.8f));
  return camera;
}

TEST(TriangleSieve, LeavesThePictureOfGravelAndWallsAsItIs) {
  double share = 0;
  for (std::uint32_t seed = 1; seed <= 6; ++seed) {
    const Building building = gravel(seed);
    Renderer renderer(sharedContext(), building);
    Dice dice(100 + seed);
    for (int i = 0; i < 20; ++i) {
      const Camera camera = anyCamera(dice, {glm::vec3(-6), glm::vec3(6)});
      share += expectTheSame(renderer, building, camera.view()) / 120;
    }
  }
  EXPECT_LT(share, 0.5);  // or the comparison would say little
  EXPECT_GT(share, 0.01);
}

TEST(TriangleSieve, LeavesThePictureAsItIsFarFromTheOriginWhereRoundingIsCoarse) {
  Building building = gravel(9);
  const glm::vec3 far_off(20000, 300, -7000);
  for (Node& node : building.nodes) {
    node.world_from_node = glm::translate(glm::mat4(1), far_off) * node.world_from_node;
  }
  Renderer renderer(sharedContext(), building);
  Dice dice(7);
  for (int i = 0; i < 20; ++i) {
    Camera camera = anyCamera(dice, {glm::vec3(-6), glm::vec3(6)});
    camera.pose.position += far_off;
    expectTheSame(renderer, building, camera.view());
  }
}

TEST(TriangleSieve, LeavesThePictureOfAnyProjectionAsItIs) {
  const Building building = gravel(4);
  Renderer renderer(sharedContext(), building);
  const glm::mat4 oblique(1, 0, 0.2f, 0, 0, 1, 0.1f, 0, 0, 0, 1, 0, 0, 0, 0, 1);
  for (const glm::mat4& clip_from_camera : {glm::frustum(-0.3f, 0.1f, 0.05f, 0.4f, 0.2f, 40.0f),
                                            glm::ortho(-3.f, 3.f, -2.f, 3.f, -8.f, 9.f),
                                            oblique * glm::perspective(1.3f, 1.25f, 0.1f, 50.0f),
                                            37.0f * glm::perspective(1.0f, 1.25f, 0.1f, 50.0f)}) {
    View view;
    view.clip_from_world =
        clip_from_camera * glm::lookAt(glm::vec3(3, 2, 5), glm::vec3(0), {0, 1, 0});
    view.eye = {3, 2, 5};
    expectTheSame(renderer, building, view);
  }
}

/// Triangles on and between pixel centres: their corners are next to whole eighths of a pixel, so
/// that the rasteriser, which moves them to its grid, moves them over centres and turns slivers
/// round.
TEST(TriangleSieve, LeavesOutNoTriangleThatByItselfDrawsAPixel) {
  constexpr int kTriangles = 4000;
  const float pixel = 2.0f / kHeight;  // at z = −1
  Dice dice(3);
  Building building;
  for (int t = 0; t < kTriangles; ++t) {
    glm::vec2 step(dice.uniform(-1.2f, 1.2f), dice.uniform(-1.2f, 1.2f));
    glm::vec2 other(dice.uniform(-1.2f, 1.2f), dice.uniform(-1.2f, 1.2f));
    glm::vec2 at(dice.uniform(-70, 70), dice.uniform(-60, 60));
    if (dice.oneIn(3)) {  // a sliver through a centre
      step = glm::round(2.0f * step) / 2.0f;
      other = 0.5f * step;
      at = glm::floor(at) + 0.5f - 0.25f * step;
    }
    std::vector<glm::vec3> corners;
    for (const glm::vec2& corner : {at, at + step, at + other}) {
      const glm::vec2 jitter(dice.uniform(-0.004f, 0.004f), dice.uniform(-0.004f, 0.004f));
      corners.emplace_back((glm::round(corner * 8.0f) / 8.0f + jitter) * pixel, -1.0f);
    }
    Material material = unlitMaterial({1, 0, 0, 1});
    material.double_sided = dice.oneIn(2);
    addTriangles(building, corners, material);
  }
  Renderer renderer(sharedContext(), building);
  const View view = frontCamera(kWidth, kHeight).view();
  int drawn = 0, left_out = 0, kept_in_vain = 0;
  for (std::uint32_t o = 0; o < kTriangles; ++o) {
    const auto paint = [&](bool sifting, Image& image) {
      renderer.setSifting(sifting);
      renderer.begin(kWidth, kHeight);
      const std::size_t triangles = renderer.draw({&o, 1}, view).triangles;
      renderer.readColor(image);
      return triangles;
    };
    Image plain, sifted;
    paint(false, plain);
    const bool kept = paint(true, sifted) == 1;
    ASSERT_EQ(plain.rgba, sifted.rgba) << "triangle " << o;
    bool shows = false;
    for (std::size_t i = 0; i < plain.rgba.size(); i += 4) shows |= plain.rgba[i + 1] == 0;
    drawn += shows;
    left_out += !kept;
    kept_in_vain += kept && !shows;
  }
  EXPECT_GT(drawn, kTriangles / 8);
  EXPECT_GT(left_out, kTriangles / 3);
  EXPECT_LT(kept_in_vain, kTriangles / 2);  // most are slivers
}

TEST(TriangleSieve, LeavesOutWhatIsBehindAWall) {
  Building building;
  addQuad(building, rectangle({-9, -9}, {9, 9}, -2), unlitMaterial({1, 0, 0, 1}));
  for (int i = 0; i < 50; ++i) {
    const float x = 0.1f * static_cast<float>(i) - 2.5f;
    addQuad(building, rectangle({x, -0.1f}, {x + 0.1f, 0.1f}, -3), unlitMaterial({0, 1, 0, 1}));
  }
  Renderer renderer(sharedContext(), building);
  const View view = frontCamera(kWidth, kHeight).view();
  // All but some on the wall's diagonal, where neither of its triangles covers a whole square.
  EXPECT_LT(expectTheSame(renderer, building, view), 0.5);
}

TEST(TriangleSieve, WhatIsSeenThroughAWallWithHolesStays) {
  for (const AlphaMode mode : {AlphaMode::kMask, AlphaMode::kBlend}) {
    Building building;
    building.images.push_back({"", checkers(32, 4, {255, 255, 255, 255}, {90, 60, 30, 0}), {}, ""});
    Material wall = unlitMaterial({1, 0, 0, 1});
    wall.image = 0;
    wall.alpha_mode = mode;
    addQuad(building, rectangle({-9, -9}, {9, 9}, -2), wall);
    addQuad(building, rectangle({-2, -2}, {2, 2}, -3), unlitMaterial({0, 1, 0, 1}));
    Renderer renderer(sharedContext(), building);
    EXPECT_EQ(expectTheSame(renderer, building, frontCamera(kWidth, kHeight).view()), 1.0);
  }
}

TEST(TriangleSieve, LeavesThePictureAsItIsByWhicheverVectorUnit) {
  const Building building = gravel(3);
  Renderer renderer(sharedContext(), building);
  int units = 0;
  std::int64_t rest = hwy::SupportedTargets();
  for (int bit = 0; rest != 0; ++bit) {
    const std::int64_t unit = std::int64_t{1} << bit;
    if ((rest & unit) == 0) continue;
    rest &= ~unit;
    hwy::SetSupportedTargetsForTest(unit);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
    Dice dice(21);
    for (int i = 0; i < 8; ++i) {
      const Camera camera = anyCamera(dice, {glm::vec3(-6), glm::vec3(6)});
      EXPECT_LT(expectTheSame(renderer, building, camera.view()), 0.9) << hwy::TargetName(unit);
    }
    ++units;
  }
  hwy::SetSupportedTargetsForTest(0);
  hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  EXPECT_GT(units, 0);
}

TEST(TriangleSieve, KeepsTheOrderOfObjectsAndTheirTriangles) {
  const Building building = gravel(2);
  const WorldGeometry world = worldGeometry(building);
  TriangleSieve sieve(world);
  std::vector<SieveObject> objects;
  for (std::uint32_t o = 0; o < building.objects.size(); ++o) objects.push_back({o, true, false});
  SieveView view;
  view.clip_from_world = frontCamera(kWidth, kHeight).clipFromWorld();
  view.width = kWidth;
  view.height = kHeight;
  sieve.sift(objects, view);
  auto next = world.indices.begin();
  std::size_t end = 0;
  for (const SieveObject& object : objects) {
    const IndexRange& range = sieve.range(object.object);
    if (range.count == 0) continue;
    EXPECT_EQ(range.first, end);
    end += range.count;
    for (std::size_t i = range.first; i < end; i += 3) {
      const auto corner = sieve.indices().begin() + static_cast<std::ptrdiff_t>(i);
      while (next < world.indices.end() && !std::equal(corner, corner + 3, next)) next += 3;
      ASSERT_TRUE(next < world.indices.end());
    }
  }
  EXPECT_EQ(end, sieve.indices().size());
}

TEST(TriangleSieve, IsTheSameForAnyNumberOfThreads) {
  Building building = gravel(5);
  // The same again and again: enough to be shared out.
  const std::vector<Object> objects_once = building.objects;
  for (int i = 0; i < 15; ++i) {
    building.objects.insert(building.objects.end(), objects_once.begin(), objects_once.end());
  }
  const WorldGeometry world = worldGeometry(building);
  ASSERT_GT(world.indices.size() / 3, 80000u);
  std::vector<SieveObject> objects;
  for (std::uint32_t o = 0; o < world.objects.size(); ++o) objects.push_back({o, false, true});
  SieveView view;
  view.clip_from_world = frontCamera(kWidth, kHeight).clipFromWorld();
  view.width = kWidth;
  view.height = kHeight;
  const auto siftWith = [&](int threads) {
    TriangleSieve sieve(world);
    sieve.sift(objects, view, threads);
    return std::vector<std::uint32_t>(sieve.indices().begin(), sieve.indices().end());
  };
  EXPECT_EQ(siftWith(1), siftWith(3));
}

void compareModel(const char* name) {
  const std::string file = std::string(ENFILADE_SOURCE_DIR "/../shared/models/") + name;
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the model " << file << " is not there";
  const Building building = readGltf(file);
  Renderer renderer(sharedContext(), building);
  Dice dice(11);
  double share = 0;
  for (int i = 0; i < 40; ++i) {
    share += expectTheSame(renderer, building, anyCamera(dice, worldBounds(building)).view()) / 40;
  }
  EXPECT_LT(share, 0.5);
}

TEST(TriangleSieve, LeavesThePictureOfTheDuplexHouseAsItIs) { compareModel("duplex.glb"); }
TEST(TriangleSieve, LeavesThePictureOfTheGameMapAsItIs) { compareModel("freedoom-e1m1.glb"); }
TEST(TriangleSieve, LeavesThePictureOfTheFlatAsItIs) { compareModel("dream-apartment.glb"); }

}  // namespace
}  // namespace enfilade
