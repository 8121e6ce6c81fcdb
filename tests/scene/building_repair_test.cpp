#include "scene/building_repair.h"

#include <gtest/gtest.h>

#include <limits>

namespace enfilade {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Building withMeshes(const VertexArrays& vertices,
                    const std::vector<std::vector<std::uint32_t>>& index_lists) {
  Building building;
  building.vertex_arrays = {vertices};
  for (const auto& indices : index_lists) {
    building.meshes.push_back({.name = "", .vertices = 0, .indices = indices});
  }
  return building;
}

TEST(MendNormals, WeighsTheTrianglesOfAllMeshesByTheirArea) {
  // Vertex 0 joins a triangle facing +z of area 2 and, in another mesh, one facing +x of area 1.
  const VertexArrays vertices{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, 2, 0}, {0, 0, 1}},
                              {{0, 0, 0}, {0, 0, 1}, {0, 3, 0}, {1, 0, 0}, {kNan, 0, 0}},
                              {},
                              {}};
  Building building = withMeshes(vertices, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(mendNormals(building), 2u);
  const std::vector<glm::vec3>& normals = building.vertex_arrays[0].normals;
  EXPECT_NEAR(normals[0].x, 1.0f / std::sqrt(5.0f), 1e-6f);
  EXPECT_NEAR(normals[0].z, 2.0f / std::sqrt(5.0f), 1e-6f);
  EXPECT_EQ(normals[2], glm::vec3(0, 1, 0)) << "made unit";
  EXPECT_EQ(normals[4], glm::vec3(1, 0, 0));
}

TEST(MendNormals, PointsUpWhereThereIsNothingToGoBy) {
  Building building = withMeshes({{{0, 0, 0}}, {{0, 0, 0}}, {}, {}}, {});
  EXPECT_EQ(mendNormals(building), 1u);
  EXPECT_EQ(building.vertex_arrays[0].normals[0], glm::vec3(0, 1, 0));
}

TEST(MendNormals, LeavesUnitNormalsAsTheyAreToTheBit) {
  const glm::vec3 almost = glm::normalize(glm::vec3(1, 2, 3)) * 1.00001f;
  Building building = withMeshes({{{0, 0, 0}}, {almost}, {}, {}}, {});
  EXPECT_EQ(mendNormals(building), 0u);
  EXPECT_EQ(building.vertex_arrays[0].normals[0], almost);
}

TEST(DropUnusedVertexArrays, KeepsTheOthersAndTheirMeshes) {
  Building building;
  for (const float x : {0.0f, 1.0f, 2.0f}) {
    building.vertex_arrays.push_back({{{x, 0, 0}}, {}, {}, {}});
  }
  building.meshes = {{.name = "", .vertices = 2}, {.name = "", .vertices = 0}};
  dropUnusedVertexArrays(building);
  ASSERT_EQ(building.vertex_arrays.size(), 2u);
  EXPECT_EQ(building.vertex_arrays[building.meshes[0].vertices].positions[0].x, 2.0f);
  EXPECT_EQ(building.vertex_arrays[building.meshes[1].vertices].positions[0].x, 0.0f);
}

TEST(CountWithoutArea, CountsPointsAndLinesButNotSlivers) {
  const VertexArrays vertices{
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1e-20f, 0}, {0, 1, 0}}, {}, {}, {}};
  const Building building =
      withMeshes(vertices, {{0, 1, 4}, {0, 0, 4, 0, 1, 2}, {0, 2, 3, 1, 1, 1}});
  EXPECT_EQ(countWithoutArea(building), 3u);
}

}  // namespace
}  // namespace enfilade
