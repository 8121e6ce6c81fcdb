#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "portals/house.h"

namespace enfilade {

/// What a shut door takes of the floor: upright and convex, around its portal and its leaves.
struct WalkBarrier {
  std::vector<glm::vec2> outline;  ///< x and z [m], convex, turning from +x to +z; two for a line
  glm::vec2 least{0}, most{0};     ///< of the outline
  float bottom = 0, top = 0;       ///< [m]

  /// The distance of a point of the floor to the outline [m], negative inside; `far` or more where
  /// it is more than that.
  float distance(const glm::vec2& p, float far) const noexcept;
};

/// One a portal, shut or not.
std::vector<WalkBarrier> walkBarriers(const House& house);

}  // namespace enfilade
