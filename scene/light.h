#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace enfilade {

enum class LightKind : std::uint8_t { kPoint, kSpot, kDirectional };

/// A lamp, or the sun.  It shines from its node's origin; a spot or a directional one along the
/// node's −Z.
/// Source: Khronos, glTF extension KHR_lights_punctual.
struct Light {
  std::string name;
  std::uint32_t node = 0xffffffffu;  ///< index in Building::nodes
  LightKind kind = LightKind::kPoint;
  glm::vec3 color{1};          ///< linear, [≥ 0]
  float intensity = 1;         ///< [≥ 0] [cd]; of a directional one [lx]
  float range = 0;             ///< [m] [≥ 0] where it ends; 0: nowhere
  float inner_angle = 0;       ///< [rad] [0…outer) of a spot: from its axis to where it fades
  float outer_angle = 0.785f;  ///< [rad] (0…π/2] of a spot: to where it is dark
};

}  // namespace enfilade
