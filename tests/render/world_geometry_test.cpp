#include "render/world_geometry.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include "render/shading.h"
#include "tests/render/test_scenes.h"

namespace enfilade {
namespace {

using namespace test;

TEST(WorldGeometry, HoldsEachObjectsVerticesInTheWorld) {
  Building building;
  const glm::mat4 transform =
      glm::rotate(glm::translate(glm::mat4(1), {1, 2, 3}), 0.7f, glm::vec3(0, 1, 0));
  addQuad(building, rectangle({0, 0}, {1, 1}, 0), unlitMaterial({1, 0, 0, 1}));
  addQuad(building, rectangle({0, 0}, {2, 1}, 0), unlitMaterial({0, 1, 0, 1}), transform);
  building.meshes[1].indices.resize(3);
  const WorldGeometry world = worldGeometry(building);
  ASSERT_EQ(world.objects.size(), 2u);
  EXPECT_EQ(world.objects[1].first, 6u);
  EXPECT_EQ(world.objects[1].count, 3u);
  EXPECT_EQ(world.vertices.size(), 7u);  // the last corner of the second is in no triangle
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::vec3 expected(transform * glm::vec4(building.vertex_arrays[1].positions[i], 1.0f));
    EXPECT_EQ(world.vertices[world.indices[6 + i]].position, expected);
    EXPECT_EQ(world.vertices[world.indices[6 + i]].front, glm::u8vec4(0, 255, 0, 255));
  }
}

TEST(WorldGeometry, NormalsFollowStretchedAndMirroredTransforms) {
  const auto corners = rectangle({0, 0}, {1, 1}, 0);
  const glm::mat4 tilt = glm::rotate(glm::mat4(1), 0.5f, glm::vec3(0.6f, 0, 0.8f));
  for (const glm::vec3 scale : {glm::vec3(1), glm::vec3(3, 0.2f, 1), glm::vec3(-1, 2, 0.5f)}) {
    const glm::mat4 transform =
        glm::scale(glm::rotate(glm::mat4(1), 0.3f, {0, 1, 0}), scale) * tilt;
    Building building;
    Material material;
    addQuad(building, corners, material, transform);
    const WorldGeometry world = worldGeometry(building);
    const auto at = [&](std::size_t i) { return world.vertices[world.indices[i]].position; };
    const glm::vec3 normal = glm::normalize(glm::cross(at(1) - at(0), at(2) - at(0)));
    EXPECT_NEAR(world.vertices[0].front.r, 255 * skyAndSun(normal), 0.6) << scale.x;
    EXPECT_NEAR(world.vertices[0].back.r, 255 * skyAndSun(-normal), 0.6) << scale.x;
  }
}

TEST(WorldGeometry, FlattenedAndEmptyObjectsAreNoError) {
  Building building;
  addQuad(building, rectangle({0, 0}, {1, 1}, 0), Material{},
          glm::scale(glm::mat4(1), glm::vec3(1, 1, 0)));
  addQuad(building, rectangle({0, 0}, {1, 1}, 0), Material{}, glm::mat4(0));
  addQuad(building, rectangle({0, 0}, {1, 1}, 0), Material{});
  building.meshes[2].indices.clear();
  const WorldGeometry world = worldGeometry(building);
  EXPECT_EQ(world.indices.size(), 12u);
  EXPECT_EQ(world.objects[2].count, 0u);
}

TEST(Shading, LightStaysBetweenBlackAndWhiteAndTellsWallsApart) {
  const glm::vec3 ways[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (const glm::vec3& a : ways) {
    for (const glm::vec3& b : ways) {
      if (a == b) continue;
      EXPECT_GT(std::abs(skyAndSun(a) - skyAndSun(b)), 0.04f);
    }
  }
  for (int i = 0; i < 10000; ++i) {
    const float y = static_cast<float>(i) / 5000.0f - 1.0f;
    const float angle = static_cast<float>(i) * 2.4f;
    const float r = std::sqrt(std::max(0.0f, 1 - y * y));
    const float light = skyAndSun({r * std::cos(angle), y, r * std::sin(angle)});
    ASSERT_GT(light, 0.4f);
    ASSERT_LE(light, 1.0f);
  }
}

}  // namespace
}  // namespace enfilade
