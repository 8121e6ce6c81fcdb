#pragma once

#include <cstddef>
#include <span>

#include "ibr/ldi.h"
#include "ibr/warp_transform.h"

namespace enfilade {

inline constexpr std::size_t kWarpBatch = 128;  ///< a multiple of any vector

/// Where a batch of samples falls in the desired image, and how large it is there.
struct WarpedBatch {
  alignas(64) float x[kWarpBatch];            ///< pixels
  alignas(64) float y[kWarpBatch];            ///< pixels
  alignas(64) float disparity[kWarpBatch];    ///< in the desired image; ≤ 0: behind the eye
  alignas(64) float half_width[kWarpBatch];   ///< of the box of the sample's footprint [pixels]
  alignas(64) float half_height[kWarpBatch];  ///< of the same
};

/// The transform of one tile's samples, from places within the tile.
struct TileTransform {
  float origin[3];  ///< of the tile's corner
  float per_x[3];   ///< per pixel
  float per_y[3];
  float per_disparity[3];
};

TileTransform tileTransform(const WarpTransform& warp, const LdiTile& tile) noexcept;

/// Warps at most kWarpBatch samples of a tile.  A sample's footprint is taken to face the LDI's
/// viewpoint.
void warpBatch(const TileTransform& transform, std::span<const LdiSample> samples,
               WarpedBatch& out) noexcept;

}  // namespace enfilade
