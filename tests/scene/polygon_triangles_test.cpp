#include "scene/polygon_triangles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

namespace enfilade {
namespace {

struct Outline {
  const char* name;
  std::vector<glm::vec2> corners;
  float area;
};

const std::vector<Outline> kOutlines{
    {"square", {{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 4},
    {"dart", {{0, 0}, {2, 1}, {4, 0}, {2, 4}}, 6},
    {"L", {{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 12},
    {"U", {{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, 20},
    {"doorway", {{0, 0}, {2, 0}, {2, 2}, {3, 2}, {3, 0}, {5, 0}, {5, 3}, {0, 3}}, 13},
    {"corner in an edge", {{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, 4},
    {"hole by a bridge",
     {{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}},
     12}};

/// How the triangles' areas add up, each counted by the way it faces.
std::pair<float, float> areasOf(const std::vector<glm::vec3>& corners, const glm::vec3& normal) {
  float signed_area = 0, area = 0;
  for (const auto& [a, b, c] : polygonTriangles(corners)) {
    const glm::vec3 n = 0.5f * glm::cross(corners[b] - corners[a], corners[c] - corners[a]);
    signed_area += glm::dot(n, normal);
    area += glm::length(n);
  }
  return {signed_area, area};
}

TEST(PolygonTriangles, FillPolygonsWhereverTheyStandAndBegin) {
  for (const Outline& outline : kOutlines) {
    for (int place = 0; place < 12; ++place) {
      for (std::size_t start = 0; start < outline.corners.size(); ++start) {
        SCOPED_TRACE(std::string(outline.name) + " " + std::to_string(place));
        glm::mat4 m = glm::translate(glm::mat4(1), glm::vec3(-15 + 3 * place, 7 - place, 2));
        m = glm::rotate(m, 0.5f * static_cast<float>(place), glm::vec3(0.3f, 1, 0.2f));
        std::vector<glm::vec3> corners;
        for (const glm::vec2& p : outline.corners) {
          corners.emplace_back(m * glm::vec4(p, 0, 1));
        }
        std::rotate(corners.begin(), corners.begin() + std::ptrdiff_t(start), corners.end());
        const glm::vec3 normal(m * glm::vec4(0, 0, 1, 0));
        const auto [facing, all] = areasOf(corners, normal);
        EXPECT_NEAR(facing, outline.area, 1e-3f);
        EXPECT_NEAR(all, outline.area, 1e-3f) << "none faces away or covers another";
        std::reverse(corners.begin(), corners.end());
        EXPECT_NEAR(areasOf(corners, normal).first, -outline.area, 1e-3f);
      }
    }
  }
}

TEST(PolygonTriangles, OfWhatHasNoAreaAreNone) {
  EXPECT_TRUE(polygonTriangles({}).empty());
  const std::vector<glm::vec3> point(5, glm::vec3(1));
  EXPECT_TRUE(polygonTriangles(point).empty());
}

}  // namespace
}  // namespace enfilade
