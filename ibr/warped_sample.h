#pragma once

#include "ibr/capture_samples.h"
#include "ibr/warp_transform.h"

namespace enfilade {

/// A sample of a capture as the central view sees it.
struct WarpedSample {
  float x = 0, y = 0;          ///< pixels of the central image
  float disparity = 0;         ///< ≤ 0: behind the central viewpoint, and nothing else holds
  float across = 0, down = 0;  ///< the box of its patch of surface [pixels]
};

/// `warp`: from the capture's camera to the central one.
WarpedSample warpSample(const WarpTransform& warp, const CaptureSample& sample) noexcept;

}  // namespace enfilade
