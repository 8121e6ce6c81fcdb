#pragma once

#include <span>

#include "ibr/convex_region.h"
#include "ibr/ldi.h"
#include "ibr/warp.h"
#include "ibr/warp_positions.h"

namespace enfilade {

/// How pixels are made of warped samples.
///
/// A sample covers the pixels whose centres lie in its footprint: the box of the patch of surface
/// that it stands for, as large as it appears from the desired eye.  Of what covers a pixel the
/// nearest surface counts, and of that surface the mean, by weights that fall off steeply from the
/// sample's middle.  Then a pixel between two of one nearer surface, left and right or above and
/// below, takes their mean: it is a crack in that surface.
struct Reconstruction {
  static constexpr float kFootprintScale = 1.1f;  ///< patches are made this much larger
  static constexpr float kLeastHalf = 0.5f;       ///< [pixels] so that none falls between centres
  static constexpr float kGreatestHalf = 16.0f;   ///< [pixels]
  static constexpr float kSameSurface = 1.03f;    ///< ratio of disparities within one surface
  static constexpr float kCrackDepth = 1.05f;     ///< ratio by which a crack's sides are nearer
};

/// The part of a warp buffer that is being warped into: the region's rows, the columns [left,
/// right) that hold it; of each row its own columns are in target.spans.
struct RegionOfBuffer {
  WarpBuffer& target;
  RowRange rows;
  int left = 0;
  int right = 0;
};

/// The pixels of a convex polygon in `target`, whose spans are set.
RegionOfBuffer regionOf(std::span<const glm::vec2> polygon, WarpBuffer& target) noexcept;

void clearRegion(const RegionOfBuffer& region) noexcept;

/// Adds a batch of warped samples.
void addSamples(const RegionOfBuffer& region, const WarpedBatch& batch,
                std::span<const LdiSample> samples) noexcept;

/// Turns what was added to `rows` of the region into colours, and counts their pixels.
void resolveRegion(const RegionOfBuffer& region, RowRange rows, WarpCounts& counts) noexcept;

}  // namespace enfilade
