#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "ibr/hole_filling.h"
#include "ibr/warp.h"

namespace enfilade {

/// How portals' images are warped into the frame.
struct Warping {
  Splat splat = Splat::kMean;
  Holes holes = Holes::kNothing;
  Clip clip = Clip::kTiles;
};

/// Adds --splat, --holes and --clip, which set `warping`.
void addWarpingOptions(CLI::App& command, Warping& warping);

}  // namespace enfilade
