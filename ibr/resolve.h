#pragma once

#include <span>

#include "ibr/fragments.h"
#include "ibr/warp.h"
#include "ibr/warp_window.h"

namespace enfilade {

/// The pixels of a region that a fragment is to hand over.
struct RegionPart {
  std::span<const glm::ivec2> spans;  ///< the region's columns, one a row of the frame
  int top = 0, bottom = 0;            ///< the region's rows
  const Fragment& fragment;
};

/// Copies painted pixels to `out`; alpha 0 where nothing was painted.
void resolvePainted(const RegionPart& part, const WarpWindow& window, Image& out,
                    WarpCounts& counts) noexcept;

/// Turns sums into mean colours.  A pixel between two of one nearer surface, left and right or
/// above and below, takes their mean: it is a crack in that surface.
void resolveMeans(const RegionPart& part, const WarpWindow& window, Image& out,
                  WarpCounts& counts) noexcept;

}  // namespace enfilade
