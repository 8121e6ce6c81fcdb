#include "scene/tessellate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <set>
#include <tuple>

namespace enfilade {
namespace {

using Point = std::tuple<float, float, float>;

Point pointOf(const glm::vec3& p) { return {p.x, p.y, p.z}; }

/// A closed box of two meshes with vertex arrays of their own, each with three faces of two
/// triangles.
Building box(const glm::vec3& size) {
  const auto corner = [&](unsigned i) {
    return size * glm::vec3(i & 1u ? 1 : 0, i & 2u ? 1 : 0, i & 4u ? 1 : 0);
  };
  const std::vector<std::vector<std::uint32_t>> halves = {
      {0, 4, 6, 0, 6, 2, 0, 1, 5, 0, 5, 4, 0, 2, 3, 0, 3, 1},
      {1, 3, 7, 1, 7, 5, 2, 6, 7, 2, 7, 3, 4, 5, 7, 4, 7, 6}};
  Building building;
  building.materials.resize(1);
  building.nodes.push_back({"node", kNone, glm::mat4(1), {}});
  for (std::uint32_t half = 0; half < 2; ++half) {
    VertexArrays vertices;
    for (unsigned i = 0; i < 8; ++i) {
      vertices.positions.push_back(corner(i));
      vertices.normals.push_back(glm::normalize(corner(i) + glm::vec3(0.1f)));
      vertices.texcoords.emplace_back(corner(i));
      vertices.colors.emplace_back(i * 8000);
    }
    building.vertex_arrays.push_back(vertices);
    building.meshes.push_back({"half", half, 0, halves[half], {glm::vec3(0), size}});
    building.objects.push_back({0, half});
  }
  return building;
}

template <class Visit>
void forTriangles(const Building& building, const Visit& visit) {
  for (const Mesh& mesh : building.meshes) {
    const auto& p = building.vertex_arrays[mesh.vertices].positions;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      visit(p[mesh.indices[i]], p[mesh.indices[i + 1]], p[mesh.indices[i + 2]]);
    }
  }
}

double area(const Building& building) {
  double sum = 0;
  forTriangles(building, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  });
  return sum;
}

TEST(SplitLongEdges, LeavesNoneAndKeepsAClosedSurfaceClosed) {
  Building building = box({2.3f, 0.7f, 5.1f});
  EXPECT_EQ(splitLongEdges(building, 0.4f), 0.4f);
  std::map<std::pair<Point, Point>, int> edges;
  forTriangles(building, [&](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    for (const auto& [p, q] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
      EXPECT_LE(glm::distance(p, q), 0.4f * 1.00001f);
      ++edges[{pointOf(p), pointOf(q)}];
    }
  });
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1u) << "a crack";
  }
}

TEST(SplitLongEdges, KeepsTheAreaAndInterpolatesWhatVerticesHave) {
  Building building = box({2, 1, 3});
  const double before = area(building);
  splitLongEdges(building, 0.25f);
  EXPECT_NEAR(area(building), before, 1e-5 * before);
  for (const VertexArrays& v : building.vertex_arrays) {
    ASSERT_EQ(v.normals.size(), v.positions.size());
    ASSERT_EQ(v.texcoords.size(), v.positions.size());
    ASSERT_EQ(v.colors.size(), v.positions.size());
    for (std::size_t i = 0; i < v.positions.size(); ++i) {
      EXPECT_NEAR(glm::length(v.normals[i]), 1, 1e-5);
      EXPECT_NEAR(v.texcoords[i].x, v.positions[i].x, 1e-5);
    }
  }
}

TEST(SplitLongEdges, MeasuresWhereAnObjectIsLargest) {
  Building building = box({1, 1, 1});
  building.nodes.push_back({"small", kNone, glm::scale(glm::mat4(1), glm::vec3(0.1f)), {}});
  building.nodes.push_back({"large", kNone, glm::scale(glm::mat4(1), glm::vec3(4)), {}});
  building.objects = {{1, 0}, {2, 0}, {1, 1}};
  splitLongEdges(building, 0.5f);
  EXPECT_GT(building.meshes[0].indices.size(), 18u * 16);
  EXPECT_EQ(building.meshes[1].indices.size(), 18u) << "too small to be split";
}

TEST(SplitLongEdges, DoublesTheLengthUntilItsBudgetIsEnough) {
  Building building = box({4, 4, 4});
  const std::vector<MeshToSplit> meshes = {{0, glm::mat4(1)}, {1, glm::mat4(1)}};
  const float kept = splitLongEdges(building, meshes, 0.01f, 2000);
  EXPECT_GT(kept, 0.01f);
  EXPECT_LE(triangleCount(building), 12u + 2000u);
  EXPECT_GT(triangleCount(building), 300u);
  EXPECT_NEAR(std::log2(kept / 0.01f), std::round(std::log2(kept / 0.01f)), 1e-4);
}

TEST(SplitLongEdges, LeavesOtherMeshesAlone) {
  Building building = box({4, 4, 4});
  const std::vector<MeshToSplit> meshes = {{0, glm::mat4(1)}};
  splitLongEdges(building, meshes, 1, 100'000);
  EXPECT_GT(building.meshes[0].indices.size(), 18u);
  EXPECT_EQ(building.meshes[1].indices.size(), 18u);
}

}  // namespace
}  // namespace enfilade
