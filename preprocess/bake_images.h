#pragma once

#include <string>

#include "ibr/image_parameters.h"
#include "portals/house.h"
#include "preprocess/progress.h"
#include "render/gl_context.h"

namespace enfilade {

struct BakedImages {
  std::size_t images = 0;  ///< portal sides with images
  std::uint64_t bytes = 0;
};

/// What bakes.
struct BakingHands {
  GlBackend gl = GlBackend::kOsMesa;  ///< that draws the captures
  int threads = 0;                    ///< [≥ 0] 0: as many as the machine has
};

/// Bakes the images of the kinds in `parameters.bake` of every portal side of `house` that gets one
/// into `folder` (portalImageFolder), and lists them in `house.files`. The same bytes for any
/// number of threads.
BakedImages bakeImages(House& house, const ImageParameters& parameters, const std::string& folder,
                       const BakingHands& hands, const ProgressSink& progress);

}  // namespace enfilade
