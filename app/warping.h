#pragma once

#include <string>

#include "ibr/hole_filling.h"
#include "ibr/warp.h"

namespace CLI {
class App;
}  // namespace CLI

namespace enfilade {

/// How portals' images are warped into the frame.
struct Warping {
  Splat splat = Splat::kMean;
  Holes holes = Holes::kNothing;
  Clip clip = Clip::kTiles;
};

/// The same as it is named on the command line.
struct WarpingNames {
  std::string splat = "mean", holes = "none", clip = "tiles";
};

/// Adds --splat, --holes and --clip, which set `names`.
void addWarpingOptions(CLI::App& command, WarpingNames& names);

/// Throws Error (kUsage) for a name that is none, saying which there are.
Warping parseWarping(const WarpingNames& names);

}  // namespace enfilade
