#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <vector>

namespace enfilade {

/// The digits of `i` mirrored at the point, 0…1: a sequence that fills the line evenly.
/// Source: van der Corput, Verteilungsfunktionen, 1935; Halton 1960.
inline float radicalInverse(std::uint32_t i, std::uint32_t base) noexcept {
  float sum = 0;
  float digit = 1;
  for (; i > 0; i /= base) {
    digit /= static_cast<float>(base);
    sum += digit * static_cast<float>(i % base);
  }
  return sum;
}

/// A ray of the even set that all points use: the same noise everywhere shows as no noise.
struct LightSample {
  glm::vec3 direction;  ///< unit, about +Z, as dense as its cosine
  float chance;         ///< for glass, 0…1
  float pick;           ///< for one of three corners, 0…1
};

inline std::vector<LightSample> lightSamples(int count) {
  std::vector<LightSample> samples;
  for (int i = 0; i < count; ++i) {
    const auto n = static_cast<std::uint32_t>(i);
    const float r2 = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float angle = glm::two_pi<float>() * radicalInverse(n, 2);
    const float r = std::sqrt(r2);
    samples.push_back({{r * std::cos(angle), r * std::sin(angle), std::sqrt(1 - r2)},
                       radicalInverse(n, 3),
                       radicalInverse(n, 5)});
  }
  return samples;
}

/// Columns: two unit vectors across `unit_normal`, and itself.
/// Source: Duff et al., Building an Orthonormal Basis, Revisited, 2017.
inline glm::mat3 frameAround(const glm::vec3& unit_normal) noexcept {
  const glm::vec3& n = unit_normal;
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1.0f / (sign + n.z);
  const float b = n.x * n.y * a;
  return {glm::vec3(1 + sign * n.x * n.x * a, sign * b, -sign * n.x),
          glm::vec3(b, sign + n.y * n.y * a, -n.y), n};
}

}  // namespace enfilade
