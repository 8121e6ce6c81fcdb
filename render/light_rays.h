#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "render/surfaces.h"
#include "scene/building.h"

namespace enfilade {

/// A flat convex polygon that stops what passes it against its normal.
struct OneWayScreen {
  std::vector<glm::vec3> polygon;  ///< world [m]
  glm::vec3 normal{0, 1, 0};       ///< unit
};

/// What a ray of light met first.
struct LightHit {
  float distance = -1;           ///< [m] along the unit direction; < 0: nothing
  std::uint32_t object = kNone;  ///< index in Building::objects; kNone: a screen
  std::uint32_t triangle = 0;    ///< of the object's mesh
  float u = 0, v = 0;            ///< barycentric, of its second and third corner in the world
  bool back = false;             ///< from behind, whatever the material
};

/// Single rays through a building as light goes: both sides of every face stop it, blended material
/// lets a part of it through, masked-out texels all of it.  Thread-safe.
class LightRays {
 public:
  /// `clear`: 1 for objects that light passes; may be shorter than the objects, or empty.  Keeps a
  /// reference to `building`.  Throws Error (kMachine).
  LightRays(const Building& building, std::span<const std::uint8_t> clear,
            std::span<const OneWayScreen> screens);
  ~LightRays();
  LightRays(const LightRays&) = delete;
  LightRays& operator=(const LightRays&) = delete;

  const Surfaces& surfaces() const noexcept;

  /// The first that is met from `least` on.  Blended material is met if its alpha is more than
  /// `chance` (0…1; 1: never), screens if `screens`.
  LightHit trace(const glm::vec3& origin, const glm::vec3& unit_direction, float least, float most,
                 float chance, bool screens) const noexcept;

  /// The share of light that gets from `origin` to `most` along the direction; screens let it
  /// through.
  glm::vec3 passed(const glm::vec3& origin, const glm::vec3& unit_direction, float least,
                   float most) const noexcept;

  /// Whether any material is blended.
  bool hasGlass() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace enfilade
