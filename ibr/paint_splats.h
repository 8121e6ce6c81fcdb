#pragma once

#include <span>

#include "ibr/splat.h"
#include "ibr/warp_positions.h"
#include "ibr/warp_window.h"

namespace enfilade {

/// Warps samples of one tile and paints them into `window.painted` in the order in which they
/// stand, each over what is there, as splats of fixed size: k1x1, k2x2, k3x3, kCross.  Samples
/// whose splat does not touch the window are left out.
void paintSplats(Splat splat, const TileTransform& transform, std::span<const LdiSample> samples,
                 const WarpWindow& window) noexcept;

}  // namespace enfilade
