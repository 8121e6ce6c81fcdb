#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ibr/planar_camera.h"

namespace enfilade {

/// Of what is seen past the portal's edge, within its margin, much is the wall's inside: a patch
/// seen there counts as this much larger, so that it yields to what is seen through the portal.
inline constexpr double kDoubtBesideThePortal = 1e4;

/// The pixels of a camera's window that look through `polygon`, which lies in its image plane: row
/// y has [spans[y].x, spans[y].y).
std::vector<glm::ivec2> pixelsThrough(std::span<const glm::vec3> polygon,
                                      const PlanarCamera& camera);

}  // namespace enfilade
