#include "scene/polygon_triangles.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace enfilade {

namespace {

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

/// The corners that are left, in their order.
class Clipper {
 public:
  explicit Clipper(std::vector<glm::dvec2> polygon) : polygon_(std::move(polygon)) {
    rest_.resize(polygon_.size());
    std::iota(rest_.begin(), rest_.end(), std::size_t{0});
  }

  std::vector<std::array<std::size_t, 3>> run() {
    std::vector<std::array<std::size_t, 3>> triangles;
    while (rest_.size() >= 3) {
      const std::size_t ear = bestEar();
      const std::array<std::size_t, 3> corners = around(ear);
      if (turn(ear) != 0) triangles.push_back(corners);
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
  }

 private:
  std::array<std::size_t, 3> around(std::size_t i) const {
    const std::size_t n = rest_.size();
    return {rest_[(i + n - 1) % n], rest_[i], rest_[(i + 1) % n]};
  }
  double turn(std::size_t i) const {
    const auto [a, b, c] = around(i);
    return cross(polygon_[b] - polygon_[a], polygon_[c] - polygon_[b]);
  }
  bool isEar(std::size_t i) const {
    if (!(turn(i) > 0)) return false;
    const auto [ia, ib, ic] = around(i);
    const glm::dvec2 &a = polygon_[ia], &b = polygon_[ib], &c = polygon_[ic];
    for (const std::size_t k : rest_) {
      const glm::dvec2& p = polygon_[k];
      if (p == a || p == b || p == c)
        continue;  // where a hole's outline is joined to the outer one
      if (cross(b - a, p - a) >= 0 && cross(c - b, p - b) >= 0 && cross(a - c, p - c) >= 0) {
        return false;
      }
    }
    return true;
  }
  /// A corner in a line, else the first ear; without any, the sharpest corner.
  std::size_t bestEar() const {
    std::size_t ear = rest_.size(), sharpest = 0;
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const double t = turn(i);
      if (t == 0) return i;
      if (ear == rest_.size() && isEar(i)) ear = i;
      if (t > most) most = t, sharpest = i;
    }
    return ear < rest_.size() ? ear : sharpest;
  }

  std::vector<glm::dvec2> polygon_;
  std::vector<std::size_t> rest_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> polygonTriangles(std::span<const glm::vec3> corners) {
  if (corners.size() < 3) return {};
  if (corners.size() == 3) return {{0, 1, 2}};
  return Clipper(flattened(corners)).run();
}

}  // namespace enfilade
