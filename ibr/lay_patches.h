#pragma once

#include <span>

#include "ibr/splat.h"
#include "ibr/warp_positions.h"
#include "ibr/warp_window.h"

namespace enfilade {

/// Warps samples of one tile and lays each one's patch, as large as it appears from the desired
/// eye, on the pixels of `window` whose centres it covers: kSized paints `window.painted` in the
/// order in which the samples stand; kNearest and kMean go by `window.nearest` into
/// `window.weighted`.
void layPatches(Splat splat, const TileTransform& transform, std::span<const LdiSample> samples,
                const WarpWindow& window) noexcept;

}  // namespace enfilade
