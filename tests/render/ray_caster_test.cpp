#include "render/ray_caster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <random>

#include "render/packet_painter.h"
#include "render/renderer.h"
#include "scene/gltf_reader.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

constexpr int kWidth = 322;  // not a multiple of a packet
constexpr int kHeight = 255;

double psnr(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const double d = static_cast<double>(a.rgba[i]) - b.rgba[i];
    sum += d * d;
  }
  const double mean = sum / (0.75 * static_cast<double>(a.rgba.size()));
  return mean == 0 ? 100.0 : 10 * std::log10(255.0 * 255.0 / mean);
}

Image cast(const Building& building, const Camera& camera, int threads) {
  Image image;
  RayCaster(building, {}, threads).render(camera, kWidth, kHeight, image);
  return image;
}

/// A room with a checkered floor that recedes, walls, a fence, two panes of glass, coloured
/// corners, mirrored and one-sided things.
Building furnishedRoom() {
  Building building;
  building.images.push_back(
      {"", checkers(128, 16, {230, 220, 200, 255}, {90, 60, 30, 255}), {}, ""});
  building.images.push_back({"", checkers(64, 8, {200, 250, 200, 255}, {40, 90, 40, 0}), {}, ""});
  const auto lit = [](const glm::vec4& color) {
    Material material;
    material.base_color = color;
    return material;
  };
  Material floor = lit({1, 1, 1, 1});
  floor.image = 0;
  addQuad(building, {glm::vec3(-4, -1, 1), {4, -1, 1}, {4, -1, -12}, {-4, -1, -12}}, floor);
  building.vertex_arrays.back().texcoords = {{0, 0}, {8, 0}, {8, 13}, {0, 13}};
  Material wall = floor;
  wall.base_color = {0.4f, 0.5f, 0.9f, 1};
  wall.wrap_s = Wrap::kMirroredRepeat;
  addQuad(building, rectangle({-4, -1}, {4, 3}, -12), wall);
  building.vertex_arrays.back().texcoords = {{-1.2f, 0}, {2.3f, 0}, {2.3f, 1.4f}, {-1.2f, 1.4f}};
  addQuad(building, {glm::vec3(-4, -1, 1), {-4, -1, -12}, {-4, 3, -12}, {-4, 3, 1}},
          lit({0.8f, 0.3f, 0.2f, 1}));
  building.vertex_arrays.back().colors = {
      {65535, 0, 0, 65535}, {0, 65535, 0, 65535}, {0, 0, 65535, 65535}, {65535, 65535, 0, 65535}};
  // Turned away and one-sided: not there.
  addQuad(building, {glm::vec3(3, -1, 1), {3, -1, -12}, {3, 3, -12}, {3, 3, 1}}, lit({1, 0, 0, 1}));
  Material fence = lit({1, 1, 1, 1});
  fence.image = 1;
  fence.alpha_mode = AlphaMode::kMask;
  fence.double_sided = true;
  addQuad(building, rectangle({0.2f, -1}, {2.2f, 0.6f}, -5), fence);
  building.vertex_arrays.back().texcoords = {{0, 0}, {2, 0}, {2, 1.6f}, {0, 1.6f}};
  Material glass = lit({0.2f, 0.6f, 0.9f, 0.4f});
  glass.alpha_mode = AlphaMode::kBlend;
  glass.double_sided = true;
  addQuad(building, rectangle({-2, -0.8f}, {1, 1}, -4), glass);
  glass.base_color = {0.9f, 0.4f, 0.1f, 0.5f};
  addQuad(building, rectangle({-1, -0.6f}, {1.5f, 1.4f}, -6), glass);
  addQuad(building, rectangle({-1, -1}, {0, 0.5f}, 0), lit({0.9f, 0.9f, 0.2f, 1}),
          glm::scale(glm::translate(glm::mat4(1), {-2, 0.2f, -8}), glm::vec3(-1, 1, 1)));
  return building;
}

TEST(RayCaster, PictureIsTheRenderersPicture) {
  const Building building = furnishedRoom();
  Camera camera = frontCamera(kWidth, kHeight);
  camera.pose = poseFromAngles({0.1f, 0.2f, 0.3f}, 0.05f, -0.03f);
  const Image drawn = draw(building, camera, kWidth, kHeight);
  const Image traced = cast(building, camera, 2);
  EXPECT_GT(psnr(drawn, traced), 42.0);
  // And it is no empty picture.
  EXPECT_LT(psnr(drawn, draw(Building{}, camera, kWidth, kHeight)), 15.0);
}

TEST(RayCaster, PicturesOfRealBuildingsAreTheRenderersPictures) {
  struct Place {
    const char* name;
    glm::vec3 eye;
    float yaw;
  };
  for (const Place& place :
       {Place{"duplex.glb", {2, 1.5f, 5}, 0.5f}, Place{"freedoom-e1m1.glb", {0, 2, 0}, 0.3f},
        Place{"dream-apartment.glb", {5, 1.6f, -5}, 0.5f}}) {
    const std::string file = std::string(ENFILADE_SOURCE_DIR "/../shared/models/") + place.name;
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the model " << file << " is not there";
    const Building building = readGltf(file);
    Camera camera = frontCamera(kWidth, kHeight);
    camera.pose = poseFromAngles(place.eye, place.yaw, 0);
    EXPECT_GT(psnr(draw(building, camera, kWidth, kHeight), cast(building, camera, 2)), 35.0)
        << place.name;
  }
}

TEST(RayCaster, ThePixelsAreTheSameForAnyNumberOfThreads) {
  const Building building = furnishedRoom();
  const Camera camera = frontCamera(kWidth, kHeight);
  const Image one = cast(building, camera, 1);
  EXPECT_EQ(cast(building, camera, 2).rgba, one.rgba);
  EXPECT_EQ(cast(building, camera, 5).rgba, one.rgba);
  EXPECT_EQ(cast(building, camera, 1).rgba, one.rgba);
}

TEST(RayCaster, HiddenObjectsAreNotThere) {
  Building building;
  addQuad(building, rectangle({-9, -9}, {9, 9}, -2), unlitMaterial({1, 0, 0, 1}));
  addQuad(building, rectangle({-9, -9}, {9, 9}, -3), unlitMaterial({0, 1, 0, 1}));
  const std::vector<std::uint8_t> hidden = {1, 0};
  const RayCaster caster(building, hidden, 1);
  Image image;
  caster.render(frontCamera(8, 8), 8, 8, image);
  EXPECT_EQ(pixelAt(image, 4, 4), kGreen);
  EXPECT_EQ(caster.cast({0, 0, 0}, {0, 0, -1}, 0, 100, false).object, 1u);
}

TEST(RayCaster, CastMeetsTheNearestTriangleAsBruteForceDoes) {
  Building building;
  std::mt19937 random(3);
  const auto uniform = [&] { return static_cast<float>(random() & 0xffff) / 32767.5f - 1.0f; };
  const auto point = [&] { return glm::vec3(uniform(), uniform(), uniform()); };
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 o = 2.0f * point();
    const glm::vec3 a = 2.0f * point();
    const glm::vec3 b = 2.0f * point();
    Material material = unlitMaterial({1, 1, 1, 1});
    material.double_sided = i % 2 == 0;
    addQuad(building, {o, o + a, o + a + b, o + b}, material);
  }
  std::vector<Ray> rays(2000);
  for (Ray& ray : rays) ray = {2.0f * point(), glm::normalize(point()), 0.3f, 4.0f};
  const RayCaster caster(building, {}, 2);
  std::vector<RayHit> hits(rays.size());
  caster.cast(rays, false, hits);
  int met = 0;
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const Ray& ray = rays[r];
    double nearest = ray.max_distance;
    std::uint32_t object = kNone;
    std::uint32_t triangle = kNone;
    for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
      const auto& p = building.vertex_arrays[o].positions;
      const auto& indices = building.meshes[o].indices;
      for (std::uint32_t t = 0; t < 2; ++t) {
        const glm::dvec3 v0 = p[indices[3 * t]];
        const glm::dvec3 e1 = glm::dvec3(p[indices[3 * t + 1]]) - v0;
        const glm::dvec3 e2 = glm::dvec3(p[indices[3 * t + 2]]) - v0;
        const glm::dvec3 n = glm::cross(e1, e2);
        const glm::dvec3 d = ray.unit_direction;
        if (!building.materials[o].double_sided && glm::dot(n, d) > 0) continue;
        const glm::dvec3 to = v0 - glm::dvec3(ray.origin);
        const double distance = glm::dot(n, to) / glm::dot(n, d);
        const glm::dvec3 q = d * distance - to;
        const double u = glm::dot(glm::cross(q, e2), n) / glm::dot(n, n);
        const double v = glm::dot(glm::cross(e1, q), n) / glm::dot(n, n);
        if (u < 0 || v < 0 || u + v > 1 || distance < ray.min_distance) continue;
        if (distance < nearest) {
          nearest = distance;
          object = o;
          triangle = t;
        }
      }
    }
    EXPECT_EQ(hits[r].object, object);
    EXPECT_EQ(hits[r].triangle, triangle);
    const RayHit alone =
        caster.cast(ray.origin, ray.unit_direction, ray.min_distance, ray.max_distance, false);
    EXPECT_EQ(alone.object, hits[r].object);
    EXPECT_EQ(alone.distance, hits[r].distance);
    if (object == kNone) {
      EXPECT_LT(hits[r].distance, 0);
    } else {
      EXPECT_NEAR(static_cast<double>(hits[r].distance), nearest, 1e-4);
      ++met;
    }
  }
  EXPECT_GT(met, 500);
}

TEST(RayCaster, CastPassesMaskedTexelsBackFacesAndBlendedMaterial) {
  Building building;
  Image half;
  half.width = 2;
  half.height = 1;
  half.rgba = {255, 255, 255, 0, 255, 255, 255, 255};
  building.images.push_back({"", half, {}, ""});
  Material mask = unlitMaterial({1, 1, 1, 1});
  mask.alpha_mode = AlphaMode::kMask;
  mask.image = 0;
  mask.nearest_filter = true;
  addQuad(building, rectangle({-2, -2}, {2, 2}, -2), mask);
  Material glass = unlitMaterial({1, 1, 1, 0.5f});
  glass.alpha_mode = AlphaMode::kBlend;
  addQuad(building, rectangle({-2, -2}, {2, 2}, -3), glass);
  addQuad(building, rectangle({-2, -2}, {2, 2}, -4), unlitMaterial({1, 1, 1, 1}));
  const RayCaster caster(building, {}, 1);
  const glm::vec3 ahead(0, 0, -1);
  EXPECT_EQ(caster.cast({1, 0, 0}, ahead, 0, 10, false).object, 0u);
  EXPECT_EQ(caster.cast({-1, 0, 0}, ahead, 0, 10, false).object, 1u);
  EXPECT_EQ(caster.cast({-1, 0, 0}, ahead, 0, 10, true).object, 2u);
  EXPECT_EQ(caster.cast({-1, 0, 0}, ahead, 0, 3.5f, true).object, kNone);
  EXPECT_EQ(caster.cast({1, 0, 0}, ahead, 2.5f, 10, false).object, 1u);
  // All three are one-sided.
  EXPECT_EQ(caster.cast({1, 0, -10}, -ahead, 0, 20, false).object, kNone);
}

TEST(RayCaster, ABuildingWithoutObjectsIsAllSky) {
  const Building building;
  const RayCaster caster(building, {}, 1);
  Image image;
  caster.render(frontCamera(5, 3), 5, 3, image);
  ASSERT_EQ(image.rgba.size(), 60u);
  for (int i = 0; i < 15; ++i) EXPECT_EQ(pixelAt(image, i % 5, i / 5), kSky);
}

TEST(RayCaster, LooksAlongAPixelsRayAsItPaintsThePixel) {
  const Building building = furnishedRoom();
  const Camera camera = frontCamera(kWidth, kHeight);
  const RayCaster caster(building, {}, 1);
  Image painted;
  caster.render(camera, kWidth, kHeight, painted);
  const PixelRays rays = pixelRays(camera, kWidth, kHeight);
  int off = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const glm::vec2 at = glm::vec2(x, y) + 0.5f;
      const Sight sight =
          caster.look({rays.origin, rays.corner + at.x * rays.right + at.y * rays.down, rays.right,
                       rays.down, rays.near_plane, rays.far_plane});
      off += glm::ivec3(sight.color) != glm::ivec3(pixelAt(painted, x, y));
    }
  }
  EXPECT_LE(off, kWidth * kHeight / 10000) << "beyond what a ray alone rounds otherwise";
}

TEST(RayCaster, FindsEverySurfaceOnARayWhicheverWayItFaces) {
  Building building;
  Material glass = unlitMaterial({0, 0, 1, 0.5f});
  glass.alpha_mode = AlphaMode::kBlend;
  const auto wall = [&](float z, const Material& material, bool turned) {
    auto corners = rectangle({-1, -1}, {1, 1}, z);
    if (turned) std::swap(corners[1], corners[3]);
    return addQuad(building, corners, material);
  };
  const auto front = wall(-2, unlitMaterial({1, 0, 0, 1}), false);
  wall(-3, glass, false);
  const auto back = wall(-5, unlitMaterial({0, 1, 0, 1}), true);
  Material both = unlitMaterial({1, 1, 1, 1});
  both.double_sided = true;
  const auto last = wall(-6, both, false);
  const RayCaster caster(building, {}, 1);
  const PictureRay ray{{0.1f, 0.2f, 0}, {0, 0, -2}, {}, {}, 0, 10};
  std::vector<SurfaceOnRay> surfaces;
  caster.surfacesOn(ray, surfaces);
  ASSERT_EQ(surfaces.size(), 3u);
  EXPECT_EQ(surfaces[0].object, front);
  EXPECT_FLOAT_EQ(surfaces[0].distance, 1.0f);
  EXPECT_GT(surfaces[0].normal.z, 0);
  EXPECT_TRUE(surfaces[0].one_sided);
  EXPECT_EQ(surfaces[1].object, back);
  EXPECT_FLOAT_EQ(surfaces[1].distance, 2.5f);
  EXPECT_LT(surfaces[1].normal.z, 0);
  EXPECT_EQ(surfaces[2].object, last);
  EXPECT_FALSE(surfaces[2].one_sided);

  // What is seen from between the first two: the glass over the last, as the turned one is not
  // there.
  const Sight sight = caster.look({{0.1f, 0.2f, -2.5f}, {0, 0, -1}, {}, {}, 0, 10});
  EXPECT_FLOAT_EQ(sight.distance, 3.5f);
  EXPECT_NEAR(sight.color.r, 128, 1);
  EXPECT_EQ(sight.color.b, 255);
}

}  // namespace
}  // namespace enfilade
