#pragma once

#include <string>

#include "ibr/image_parameters.h"
#include "portals/house.h"
#include "preprocess/progress.h"

namespace enfilade {

struct BakedImages {
  std::size_t images = 0;  ///< portal sides with images
  std::uint64_t bytes = 0;
};

/// Bakes the images of the kinds in `parameters.bake` of every portal side of `house` that gets one
/// into `folder` (portalImageFolder). The same bytes for any number of threads.
BakedImages bakeImages(const House& house, const ImageParameters& parameters,
                       const std::string& folder, int threads, const ProgressSink& progress);

}  // namespace enfilade
