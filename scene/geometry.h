#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace enfilade {

/// `normal · p + d`; inside is ≥ 0, everywhere.
struct Plane {
  glm::vec3 normal{0, 1, 0};
  float d = 0;

  float signedDistance(const glm::vec3& p) const noexcept { return glm::dot(normal, p) + d; }
};

/// An axis-aligned box, metres; empty until extended.
struct Box {
  glm::vec3 min{std::numeric_limits<float>::infinity()};
  glm::vec3 max{-std::numeric_limits<float>::infinity()};

  bool empty() const noexcept { return min.x > max.x || min.y > max.y || min.z > max.z; }
  glm::vec3 center() const noexcept { return 0.5f * (min + max); }
  glm::vec3 size() const noexcept { return max - min; }
  bool contains(const glm::vec3& p) const noexcept {
    return glm::all(glm::greaterThanEqual(p, min)) && glm::all(glm::lessThanEqual(p, max));
  }
  bool overlaps(const Box& other) const noexcept {
    return glm::all(glm::lessThanEqual(min, other.max)) &&
           glm::all(glm::greaterThanEqual(max, other.min));
  }
  void extend(const glm::vec3& p) noexcept {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  void extend(const Box& other) noexcept {
    min = glm::min(min, other.min);
    max = glm::max(max, other.max);
  }
  Box grown(float by) const noexcept { return {min - glm::vec3(by), max + glm::vec3(by)}; }
};

}  // namespace enfilade
