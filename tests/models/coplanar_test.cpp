// Faces that lie in one plane, look the same way and overlap would fight for the same pixels.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "tests/models/test_geometry.h"

namespace enfilade {
namespace {

using Polygon = std::vector<glm::dvec2>;

double areaOf(const Polygon& p) {
  double twice = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    const glm::dvec2 a = p[i], b = p[(i + 1) % p.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return 0.5 * twice;
}

/// `p` clipped by the counter-clockwise triangle `t`.
Polygon clipped(Polygon p, const Polygon& t) {
  for (std::size_t e = 0; e < 3; ++e) {
    const glm::dvec2 a = t[e], d = t[(e + 1) % 3] - a;
    const auto side = [&](const glm::dvec2& q) { return d.x * (q.y - a.y) - d.y * (q.x - a.x); };
    Polygon kept;
    for (std::size_t i = 0; i < p.size(); ++i) {
      const glm::dvec2 q = p[i], r = p[(i + 1) % p.size()];
      const double sq = side(q), sr = side(r);
      if (sq >= 0) kept.push_back(q);
      if ((sq >= 0) != (sr >= 0)) kept.push_back(q + (r - q) * (sq / (sq - sr)));
    }
    p = kept;
  }
  return p;
}

struct PlaneTriangle {
  Polygon flat;  // counter-clockwise
  std::uint32_t object;
};

/// Triangles by the plane that they lie in, 0.5 mm and 0.03° apart, and by the way they face.
std::map<std::array<long, 4>, std::vector<PlaneTriangle>> byPlane(
    const std::vector<WorldTriangle>& triangles) {
  std::map<std::array<long, 4>, std::vector<PlaneTriangle>> planes;
  for (const WorldTriangle& t : triangles) {
    const glm::dvec3 a(t.a), b(t.b), c(t.c);
    const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
    const std::array<long, 4> key{std::lround(n.x * 2000 + 0.13), std::lround(n.y * 2000 + 0.13),
                                  std::lround(n.z * 2000 + 0.13),
                                  std::lround(glm::dot(n, a) * 2000 + 0.13)};
    // One frame for the whole plane, or its triangles would shift against one another.
    const glm::dvec3 m = glm::normalize(glm::dvec3(key[0], key[1], key[2]));
    const glm::dvec3 helper = std::abs(m.y) > 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 u = glm::normalize(glm::cross(helper, m)), v = glm::cross(m, u);
    Polygon flat;
    for (const glm::dvec3& p : {a, b, c}) flat.emplace_back(glm::dot(p, u), glm::dot(p, v));
    planes[key].push_back({flat, t.object});
  }
  return planes;
}

TEST(Gallery, HasNoTwoFacesInOnePlaneThatOverlap) {
  const Building building = unpaintedGallery(50'000);
  const auto planes = byPlane(
      worldTriangles(building, [&](const Object& object) { return !isMarker(building, object); }));
  int found = 0;
  for (const auto& [plane, triangles] : planes) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t j = i + 1; j < triangles.size(); ++j) {
        const Polygon common = clipped(triangles[i].flat, triangles[j].flat);
        if (common.size() < 3 || areaOf(common) < 1e-6 || ++found > 20) continue;
        const auto name = [&](std::size_t k) {
          return building.nodes[building.objects[triangles[k].object].node].name;
        };
        ADD_FAILURE() << name(i) << " and " << name(j) << " overlap by " << areaOf(common) << " m²";
      }
    }
  }
}

}  // namespace
}  // namespace enfilade
