#pragma once

#include <string>

#include "ibr/image_parameters.h"
#include "portals/house.h"
#include "preprocess/progress.h"

namespace enfilade {

struct BakedImages {
  std::size_t images = 0;
  std::uint64_t bytes = 0;
};

/// The height at which a viewer's eye is when looking at a side of a portal [m]: at the eye's
/// height above the floor there, but within the portal's own heights, since a distant eye's ray
/// comes to a high window almost level.
float eyeLevelBefore(const CellGraph& graph, const Portal& portal, bool from_front,
                     float eye_height);

/// Whether a side of a portal gets an image.
bool getsImage(const Portal& portal, bool from_front);

/// Bakes the layered depth image of every portal side of `house` that gets one into `folder`
/// (portalImageFolder). The same bytes for any number of threads.
BakedImages bakeImages(const House& house, const ImageParameters& parameters,
                       const std::string& folder, int threads, const ProgressSink& progress);

}  // namespace enfilade
