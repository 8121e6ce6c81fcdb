#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace enfilade {

/// What shines where nothing stands: luminance by direction [cd/m²].
struct SkyLight {
  glm::vec3 zenith{2700, 3000, 3600};
  glm::vec3 horizon{2500, 2600, 2700};
  glm::vec3 ground{480, 500, 420};  ///< below the horizon

  glm::vec3 along(const glm::vec3& unit_direction) const noexcept {
    const float up = unit_direction.y;
    return up < 0 ? ground : glm::mix(horizon, zenith, up);
  }
};

/// An opening between a room and the exterior, through which the sky lights the room.
struct SkyPortal {
  std::vector<glm::vec3> polygon;  ///< [m] flat and convex, at least 3
  glm::vec3 inward{0, 0, 1};       ///< unit normal, into the room
};

/// How baked light is worked out.
struct LightParameters {
  SkyLight sky;
  float longest_edge = 0.25f;  ///< [m] [≥ 0] longer edges are split first; 0: none are
  int rays = 512;              ///< [≥ 1] from a point of a large face, for light from all around
  int detail_rays = 128;       ///< [≥ 1] from one of a small face
  int sky_samples = 96;        ///< [≥ 1] of the sky portals from a point of a large face
  int detail_sky_samples = 32;
  int bounces = 6;  ///< [≥ 0]
  /// Links between points (4 bytes each) that are kept at most; more points have fewer rays.
  std::size_t most_links = 128'000'000;
  float mid_tone = 0.4f;  ///< (0…1) linear shade of the median of what is lit indoors
  int threads = 0;        ///< [≥ 0] 0: as many as the machine has
};

}  // namespace enfilade
