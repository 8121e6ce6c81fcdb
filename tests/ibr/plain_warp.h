#pragma once

#include <vector>

#include "ibr/ldi.h"
#include "ibr/planar_camera.h"
#include "ibr/splat.h"

namespace enfilade::testing {

/// A pixel of the plain warp: a colour where a sample fell, or a crack was closed.
struct PlainPixel {
  glm::dvec3 color{0};
  bool covered = false;  ///< by a sample
  bool shown = false;
  double nearest = 0, weight = 0;  ///< of what is seen there so far
};

/// What warpLdi() is to compute, written plainly: every sample's 3D point projected in double
/// precision, every pixel of the region asked whether it lies in the sample's splat.
std::vector<PlainPixel> warpPlainly(const Ldi& ldi, const PlanarCamera& desired,
                                    const std::vector<bool>& region, Splat splat);

}  // namespace enfilade::testing
