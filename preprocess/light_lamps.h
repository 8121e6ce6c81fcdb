#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "render/light_rays.h"
#include "scene/building.h"

namespace enfilade {

/// A building's lights, and what of their light reaches a point.
class Lamps {
 public:
  /// Keeps a reference to `rays`.
  Lamps(const Building& building, const LightRays& rays);

  /// Illuminance of a face at `point` that looks along `unit_normal` [lx].  What stands within 15
  /// cm of a lamp, its own shade, throws no shadow.
  glm::vec3 at(const glm::vec3& point, const glm::vec3& unit_normal) const noexcept;

 private:
  struct Lamp {
    LightKind kind;
    glm::vec3 position, forward;  ///< world; unit
    glm::vec3 strength;           ///< [cd] or [lx]
    float range;                  ///< [m] 0: none
    float cos_inner, cos_outer;
  };

  /// Without shadow.
  glm::vec3 unshadowed(const Lamp& lamp, const glm::vec3& point,
                       const glm::vec3& unit_normal) const noexcept;
  glm::vec3 passed(const Lamp& lamp, const glm::vec3& point) const noexcept;

  const LightRays& rays_;
  std::vector<Lamp> lamps_;
};

}  // namespace enfilade
