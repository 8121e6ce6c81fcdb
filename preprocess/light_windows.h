#pragma once

#include <functional>
#include <glm/glm.hpp>
#include <span>

#include "preprocess/light_parameters.h"
#include "render/light_rays.h"

namespace enfilade {

/// What a point sees in one direction through a sky portal.
struct WindowView {
  glm::vec3 direction{0};  ///< unit, outwards
  float weight = 0;        ///< of that light: the integral of the cosine that it stands for
  glm::vec3 passed{1};     ///< what glass lets through
  LightHit hit;            ///< beyond the portal; distance < 0: the sky
  float pick = 0;          ///< for one of three corners, 0…1
};

/// The sky portals as seen from inside: small, and nearly all the light that a room has, so that
/// they are looked through on purpose.
class Windows {
 public:
  /// All must outlive it.
  Windows(std::span<const SkyPortal> portals, const LightRays& rays)
      : portals_(portals), rays_(rays) {}

  /// Looks `count` times through the portals whose inner side `point` is on, the oftener through
  /// one the more light it would let in if nothing stood before it.  `take` is told of the views
  /// that no wall blocks.
  void sample(const glm::vec3& point, const glm::vec3& unit_normal, int count,
              const std::function<void(const WindowView&)>& take) const;

 private:
  std::span<const SkyPortal> portals_;
  const LightRays& rays_;
};

}  // namespace enfilade
