#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "preprocess/light_gather.h"

namespace enfilade {

/// For every point the illuminance after `bounces` of diffuse reflection [lx].  What is hidden has
/// its neighbours'.
std::vector<glm::vec3> bounceLight(const LightPoints& points, const WorldGeometry& world,
                                   const GatheredLight& gathered, int bounces, int threads);

}  // namespace enfilade
