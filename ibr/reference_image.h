#pragma once

#include "ibr/portal_capture.h"

namespace enfilade {

/// A depth image as a layered depth image of one layer, so that the same warp draws it: a sample
/// for each pixel where something is known, at the pixel's centre, its footprint the pixel.
/// Source: Rafferty et al. 1998, sec. 3.1.
Ldi referenceImage(const DepthImage& image);

/// The reference image of a portal's side from `viewpoint`: one ray a pixel.
Ldi captureReference(const Portal& portal, bool from_front, const glm::dvec3& viewpoint,
                     const ImageParameters& parameters, const CaptureFunction& capture);

}  // namespace enfilade
