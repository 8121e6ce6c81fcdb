#pragma once

#include <vector>

#include "preprocess/light_points.h"
#include "preprocess/light_tone.h"
#include "scene/building.h"

namespace enfilade {

/// `building` with the toned light in its vertex colours, multiplied with those that it has, and
/// its materials unlit; objects that are unlit already are left as they are.  Each other object has
/// a mesh and vertices of its own: those that its triangles use, in order of their first use.
/// Between the points of small faces the light is smoothed.  Meshes keep their numbers, new ones
/// follow.
Building colorByLight(const Building& building, const WorldGeometry& world,
                      const LightPoints& points, const std::vector<glm::vec3>& light,
                      const LightTone& tone, int threads);

}  // namespace enfilade
