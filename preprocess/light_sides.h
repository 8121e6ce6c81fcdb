#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "preprocess/light_points.h"
#include "render/light_rays.h"

namespace enfilade {

/// From which side each point takes its light.
struct LightSides {
  std::vector<glm::vec3> normals;  ///< unit; of a double-sided face towards its more open side
  std::vector<std::uint8_t> thin;  ///< 1: open on both sides, as a leaf is; lit alike on both
};

/// Single-sided faces take the light of their front.  Double-sided ones are probed: furniture is
/// often closed bodies of such, whose normals may look in.
LightSides chooseSides(const Building& building, const LightPoints& points, const LightRays& rays,
                       int threads);

}  // namespace enfilade
