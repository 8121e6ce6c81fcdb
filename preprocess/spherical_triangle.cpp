#include "preprocess/spherical_triangle.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

namespace enfilade {
namespace {

glm::dvec3 unitOrZero(const glm::dvec3& v) {
  const double length = glm::length(v);
  return length > 0 ? v / length : glm::dvec3(0);
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

}  // namespace

std::vector<glm::vec3> aboveHorizon(std::span<const glm::vec3> polygon, const glm::vec3& point,
                                    const glm::vec3& unit_normal) {
  std::vector<glm::vec3> above;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::vec3& p = polygon[i];
    const glm::vec3& q = polygon[(i + 1) % polygon.size()];
    const float hp = glm::dot(p - point, unit_normal), hq = glm::dot(q - point, unit_normal);
    if (hp > 0) above.push_back(p);
    if ((hp > 0) != (hq > 0)) above.push_back(p + (q - p) * (hp / (hp - hq)));
  }
  return above;
}

float cosineIntegral(std::span<const glm::vec3> polygon, const glm::vec3& point,
                     const glm::vec3& unit_normal) {
  double sum = 0;
  const glm::dvec3 n(unit_normal);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 p(glm::dvec3(polygon[i]) - glm::dvec3(point));
    const glm::dvec3 q(glm::dvec3(polygon[(i + 1) % polygon.size()]) - glm::dvec3(point));
    sum += angleBetween(p, q) * glm::dot(unitOrZero(glm::cross(p, q)), n);
  }
  return static_cast<float>(0.5 * std::abs(sum));
}

SphericalTriangle::SphericalTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
    : a_(glm::normalize(glm::dvec3(a))),
      b_(glm::normalize(glm::dvec3(b))),
      c_(glm::normalize(glm::dvec3(c))) {
  const glm::dvec3 ab = unitOrZero(glm::cross(a_, b_));
  const glm::dvec3 bc = unitOrZero(glm::cross(b_, c_));
  const glm::dvec3 ca = unitOrZero(glm::cross(c_, a_));
  if (ab == glm::dvec3(0) || bc == glm::dvec3(0) || ca == glm::dvec3(0)) return;
  alpha_ = angleBetween(ab, -ca);
  const double beta = angleBetween(bc, -ab);
  const double gamma = angleBetween(ca, -bc);
  cos_c_ = glm::dot(a_, b_);
  solid_angle_ = static_cast<float>(std::max(0.0, alpha_ + beta + gamma - glm::pi<double>()));
}

glm::vec3 SphericalTriangle::direction(float s, float t) const noexcept {
  const double area = static_cast<double>(s) * static_cast<double>(solid_angle_);
  const double sin_alpha = std::sin(alpha_), cos_alpha = std::cos(alpha_);
  const double p = std::sin(area - alpha_), q = std::cos(area - alpha_);
  const double u = q - cos_alpha, v = p + sin_alpha * cos_c_;
  const double below = (v * p + u * q) * sin_alpha;
  const double cos_b =
      below != 0 ? std::clamp(((v * q - u * p) * cos_alpha - v) / below, -1.0, 1.0) : 1.0;
  const double sin_b = std::sqrt(1 - cos_b * cos_b);
  const glm::dvec3 c = cos_b * a_ + sin_b * unitOrZero(c_ - glm::dot(c_, a_) * a_);
  const double z = 1 - static_cast<double>(t) * (1 - glm::dot(c, b_));
  const glm::dvec3 across = unitOrZero(c - glm::dot(c, b_) * b_);
  return glm::vec3(glm::normalize(z * b_ + std::sqrt(std::max(0.0, 1 - z * z)) * across));
}

}  // namespace enfilade
