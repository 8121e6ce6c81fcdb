#include "render/shading.h"

#include <cmath>

namespace enfilade {

float skyAndSun(const glm::vec3& normal) noexcept {
  // A linear term tells the six ways that walls, floors and ceilings face apart; a high sun,
  // squared so that it fades in smoothly, models round things.
  constexpr glm::vec3 kSlope(0.08f, 0.15f, 0.03f);
  constexpr glm::vec3 kSun(0.645f, 0.76f, 0.08f);  // unit
  const float sun = std::max(0.0f, glm::dot(normal, kSun));
  return 0.71f + glm::dot(normal, kSlope) + 0.12f * sun * sun;
}

glm::vec4 encodeTint(const glm::vec4& linear) noexcept {
  const auto encode = [](float v) { return std::pow(glm::clamp(v, 0.0f, 1.0f), 1.0f / 2.2f); };
  return {encode(linear.r), encode(linear.g), encode(linear.b), glm::clamp(linear.a, 0.0f, 1.0f)};
}

}  // namespace enfilade
