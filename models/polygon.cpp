#include "models/polygon.h"

#include <numeric>

namespace enfilade {

double signedArea(std::span<const glm::dvec2> polygon) {
  double twice = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    twice += planCross(polygon[i], polygon[(i + 1) % polygon.size()]);
  return 0.5 * twice;
}

bool containsPoint(std::span<const glm::dvec2> polygon, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x))
      inside = !inside;
  }
  return inside;
}

bool isConvex(std::span<const glm::dvec2> polygon) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 a = polygon[i], b = polygon[(i + 1) % n], c = polygon[(i + 2) % n];
    if (planCross(b - a, c - b) < -1e-9) return false;
  }
  return true;
}

glm::dvec2 movedCorner(const glm::dvec2& corner, const glm::dvec2& d1, double h1,
                       const glm::dvec2& d2, double h2) {
  // Solves n1·a = h1, n2·a = h2 with n the directions turned left.
  const glm::dvec2 n1 = leftOf(d1), n2 = leftOf(d2);
  const double det = planCross(n1, n2);
  return corner + glm::dvec2(h1 * n2.y - h2 * n1.y, n1.x * h2 - n2.x * h1) / det;
}

std::vector<glm::dvec2> inset(std::span<const glm::dvec2> polygon, double distance) {
  const std::size_t n = polygon.size();
  std::vector<glm::dvec2> inner;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 d1 = glm::normalize(polygon[i] - polygon[(i + n - 1) % n]);
    const glm::dvec2 d2 = glm::normalize(polygon[(i + 1) % n] - polygon[i]);
    inner.push_back(movedCorner(polygon[i], d1, distance, d2, distance));
  }
  return inner;
}

bool isInsetValid(std::span<const glm::dvec2> polygon, std::span<const glm::dvec2> inner) {
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    if (glm::dot(polygon[j] - polygon[i], inner[j] - inner[i]) <= 0) return false;
  }
  return true;
}

}  // namespace enfilade
