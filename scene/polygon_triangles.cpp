#include "scene/polygon_triangles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace enfilade {

namespace {

constexpr double kStraight = 1e-12;  // [m²] a turn of a corner that is none

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The polygon in its own plane, counter-clockwise.
std::vector<glm::dvec2> flattened(std::span<const glm::vec3> corners) {
  glm::dvec3 normal(0);  // Newell's
  const glm::dvec3 first(corners[0]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(corners[i]) - first;
    const glm::dvec3 b = glm::dvec3(corners[(i + 1) % corners.size()]) - first;
    normal += glm::cross(a, b);
  }
  int least = 0;
  for (int axis = 1; axis < 3; ++axis) {
    if (std::abs(normal[axis]) < std::abs(normal[least])) least = axis;
  }
  glm::dvec3 aside(0);
  aside[least] = 1;
  const glm::dvec3 u = glm::cross(aside, normal), v = glm::cross(normal, u);
  const double length = glm::length(u), height = glm::length(v);
  std::vector<glm::dvec2> flat;
  for (const glm::vec3& corner : corners) {
    const glm::dvec3 p = glm::dvec3(corner) - first;
    flat.push_back(length > 0 && height > 0
                       ? glm::dvec2(glm::dot(p, u) / length, glm::dot(p, v) / height)
                       : glm::dvec2(0));
  }
  return flat;
}

double turnAt(std::span<const glm::dvec2> polygon, std::span<const std::size_t> rest,
              std::size_t i) {
  const std::size_t n = rest.size();
  const glm::dvec2 &a = polygon[rest[(i + n - 1) % n]], &b = polygon[rest[i]],
                   &c = polygon[rest[(i + 1) % n]];
  return cross(b - a, c - b);
}

bool isEar(std::span<const glm::dvec2> polygon, std::span<const std::size_t> rest, std::size_t i) {
  if (turnAt(polygon, rest, i) <= kStraight) return false;
  const std::size_t n = rest.size();
  const glm::dvec2 &a = polygon[rest[(i + n - 1) % n]], &b = polygon[rest[i]],
                   &c = polygon[rest[(i + 1) % n]];
  return std::none_of(rest.begin(), rest.end(), [&](std::size_t k) {
    const glm::dvec2& p = polygon[k];
    return p != a && p != b && p != c && cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 &&
           cross(a - c, p - c) >= 0;
  });
}

/// The first ear; without any, the sharpest corner, as long as it is one.
std::size_t nextEar(std::span<const glm::dvec2> polygon, std::span<const std::size_t> rest) {
  std::size_t sharpest = rest.size();
  double most = kStraight;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    if (isEar(polygon, rest, i)) return i;
    const double turn = turnAt(polygon, rest, i);
    if (turn > most) most = turn, sharpest = i;
  }
  return sharpest;
}

}  // namespace

std::vector<std::array<std::size_t, 3>> triangulate(std::span<const glm::dvec2> polygon) {
  std::vector<std::size_t> rest(polygon.size());
  std::iota(rest.begin(), rest.end(), std::size_t{0});
  std::vector<std::array<std::size_t, 3>> triangles;
  while (rest.size() >= 3) {
    const std::size_t ear = nextEar(polygon, rest);
    if (ear == rest.size()) break;
    const std::size_t n = rest.size();
    triangles.push_back({rest[(ear + n - 1) % n], rest[ear], rest[(ear + 1) % n]});
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(ear));
  }
  return triangles;
}

std::vector<std::array<std::size_t, 3>> polygonTriangles(std::span<const glm::vec3> corners) {
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {{0, 1, 2}};
  return triangulate(flattened(corners));
}

}  // namespace enfilade
