#pragma once

#include <span>
#include <vector>

#include "ibr/portal_capture.h"

namespace enfilade {

/// The portal texture of a portal's side from `viewpoint`: what is seen through the portal's
/// bounding rectangle and its margin, `image_size` rows.
/// Source: Rafferty et al. 1998, sec. 2 and 4; Aliaga & Lastra, Architectural Walkthroughs using
/// Portal Textures, 1997.
Image captureTexture(const Portal& portal, bool from_front, const glm::dvec3& viewpoint,
                     const ImageParameters& parameters, const CaptureFunction& capture);

/// Where the corners of `polygon`, which lies in the portal's plane, are in the textures of that
/// side: 0…1 within the bounding rectangle and its margin [m]; v = 0 is the top row.
std::vector<glm::vec2> textureCoordinates(const Portal& portal, bool from_front, float margin,
                                          std::span<const glm::vec3> polygon);

}  // namespace enfilade
