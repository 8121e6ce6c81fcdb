#pragma once

#include <vector>

#include "ibr/planar_camera.h"
#include "scene/image.h"

namespace enfilade {

/// A picture with a disparity a pixel: what a planar camera saw.  Row 0 on top.
struct DepthImage {
  PlanarCamera camera;
  Image color;
  std::vector<float> disparity;  ///< 0 < δ ≤ 1, one a pixel; the sky has a very small δ; 0: the
                                 ///< pixel lies outside of the portal, nothing is known there
};

}  // namespace enfilade
