#pragma once

#include <functional>
#include <string>
#include <vector>

#include "ibr/image_parameters.h"
#include "portals/house.h"
#include "preprocess/progress.h"
#include "render/gl_context.h"

namespace enfilade {

struct BakedImages {
  std::size_t images = 0;  ///< portal sides with images
  std::uint64_t bytes = 0;
};

/// The stage that progress is told of.
inline constexpr const char* kBakingStage = "bake the portals' images";

/// What bakes.
struct BakingHands {
  GlBackend gl = GlBackend::kOsMesa;      ///< that draws the captures
  int threads = 0;                        ///< [≥ 0] 0: as many as the machine has
  std::function<void()> checkpoint = {};  ///< called before each capture; throws to stop
  /// Told before the work: the portal sides that are baked already, and all.
  std::function<void(std::size_t baked, std::size_t all)> sides = {};
};

/// The sides of portals that get images.
std::vector<PortalSide> sidesWithImages(const CellGraph& graph);

/// Bakes the images of the kinds in `parameters.bake` of every portal side of `house` that gets one
/// into `folder` (see SideFolder), and lists them in `house.files`.  Sides that are recorded
/// there are taken as they are, so that baking can be stopped whenever and gone on with.  The same
/// bytes for any number of threads.  Throws Error (kMachine).
BakedImages bakeImages(House& house, const ImageParameters& parameters, const std::string& folder,
                       const BakingHands& hands, const ProgressSink& progress);

}  // namespace enfilade
