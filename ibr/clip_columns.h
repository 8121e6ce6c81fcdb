#pragma once

#include <span>

#include "ibr/region_clip.h"
#include "ibr/warp_transform.h"

namespace enfilade {

/// Clips whole columns of an LDI's tiles, recursively: columns whose box, by their least and
/// greatest disparity, cannot fall into the region are left out at once, others halved and tried
/// again down to one.  `boxes`: one a tile of `ldi`; is set to where the splats of the tile's
/// columns may fall, or to an empty box.
/// Source: Popescu, Lastra, Aliaga & Oliveira, Efficient Warping for Architectural Walkthroughs
/// Using Layered Depth Images, 1998.
void clipByColumns(const Ldi& ldi, const WarpTransform& warp, const RegionClip& clip,
                   std::span<ScreenBox> boxes) noexcept;

}  // namespace enfilade
