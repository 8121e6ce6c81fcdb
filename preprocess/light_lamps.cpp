#include "preprocess/light_lamps.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace enfilade {
namespace {

constexpr float kOwnShade = 0.15f;    // [m] within which nothing throws a shadow
constexpr float kLampRadius = 0.06f;  // shadows are as soft as those of such a ball [m]
constexpr float kFarAway = 1e4f;      // [m]
constexpr float kTooDim = 0.02f;      // no shadow is looked for [lx]
constexpr float kNearest = 0.05f;     // light grows no more nearer than this [m]

// Corners of a tetrahedron on the unit ball, and its middle.
constexpr std::array<glm::vec3, 5> kOnLamp = {{{0, 0, 0},
                                               {0.577f, 0.577f, 0.577f},
                                               {0.577f, -0.577f, -0.577f},
                                               {-0.577f, 0.577f, -0.577f},
                                               {-0.577f, -0.577f, 0.577f}}};

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

}  // namespace

Lamps::Lamps(const Building& building, const LightRays& rays) : rays_(rays) {
  for (const Light& light : building.lights) {
    const glm::mat4& m = building.nodes[light.node].world_from_node;
    lamps_.push_back({light.kind, glm::vec3(m[3]), unitOr(-glm::vec3(m[2]), glm::vec3(0, -1, 0)),
                      light.intensity * light.color, light.range, std::cos(light.inner_angle),
                      std::cos(light.outer_angle)});
  }
}

glm::vec3 Lamps::unshadowed(const Lamp& lamp, const glm::vec3& point,
                            const glm::vec3& unit_normal) const noexcept {
  if (lamp.kind == LightKind::kDirectional) {
    return lamp.strength * std::max(0.0f, -glm::dot(lamp.forward, unit_normal));
  }
  const glm::vec3 to_lamp = lamp.position - point;
  const float distance = std::max(glm::length(to_lamp), kNearest);
  const glm::vec3 direction = to_lamp / distance;
  const float cosine = glm::dot(direction, unit_normal);
  if (cosine <= 0 || (lamp.range > 0 && distance >= lamp.range)) return glm::vec3(0);
  glm::vec3 light = lamp.strength * cosine / (distance * distance);
  if (lamp.range > 0) {
    const float part = distance / lamp.range;
    light *= std::clamp(1 - part * part * part * part, 0.0f, 1.0f);
  }
  if (lamp.kind == LightKind::kSpot) {
    const float along = -glm::dot(direction, lamp.forward);
    const float fade = (along - lamp.cos_outer) / std::max(lamp.cos_inner - lamp.cos_outer, 1e-3f);
    light *= std::clamp(fade, 0.0f, 1.0f) * std::clamp(fade, 0.0f, 1.0f);
  }
  return light;
}

glm::vec3 Lamps::passed(const Lamp& lamp, const glm::vec3& point) const noexcept {
  if (lamp.kind == LightKind::kDirectional) {
    return rays_.passed(point, -lamp.forward, 0, kFarAway);
  }
  glm::vec3 sum(0);
  for (const glm::vec3& on_lamp : kOnLamp) {
    const glm::vec3 way = lamp.position + kLampRadius * on_lamp - point;
    const float distance = glm::length(way);
    sum += distance <= kOwnShade ? glm::vec3(1)
                                 : rays_.passed(point, way / distance, 0, distance - kOwnShade);
  }
  return sum / static_cast<float>(kOnLamp.size());
}

glm::vec3 Lamps::at(const glm::vec3& point, const glm::vec3& unit_normal) const noexcept {
  glm::vec3 sum(0);
  for (const Lamp& lamp : lamps_) {
    const glm::vec3 light = unshadowed(lamp, point, unit_normal);
    if (std::max({light.r, light.g, light.b}) < kTooDim) continue;
    sum += light * passed(lamp, point);
  }
  return sum;
}

}  // namespace enfilade
