// McMillan & Bishop, Plenoptic Modeling, 1995: linear in (u, v, δ) before the divide.
#include "ibr/warp_positions.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ibr/warp_positions.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set

#include "ibr/warp_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::HWY_NAMESPACE {

void warpBatch(const TileTransform& transform, const LdiSample* samples, std::size_t count,
               WarpedBatch& out) {
  const DF df;
  const StoredTransform stored(transform);
  for (std::size_t i = 0; i < count; i += hn::Lanes(df)) {
    VU color, place;
    loadSamples(samples, i, count, color, place);
    const WarpedLanes lanes = warpLanes(stored, place);
    VF across, down;
    halfPatches(color, lanes.scale, across, down);
    hn::StoreU(lanes.x, df, out.x + i);
    hn::StoreU(lanes.y, df, out.y + i);
    hn::StoreU(lanes.disparity, df, out.disparity + i);
    hn::StoreU(halfFootprint(transform, 0, lanes.x, across, down), df, out.half_width + i);
    hn::StoreU(halfFootprint(transform, 1, lanes.y, across, down), df, out.half_height + i);
  }
}

}  // namespace enfilade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace enfilade {

TileTransform tileTransform(const WarpTransform& warp, const LdiTile& tile) noexcept {
  const glm::dvec3 corner = warp.homogeneous(tile.x * kLdiTile, tile.y * kLdiTile, 0.0);
  TileTransform t;
  for (int i = 0; i < 3; ++i) {
    t.origin[i] = static_cast<float>(corner[i]);
    t.per_x[i] = static_cast<float>(warp.to_from_pixel[0][i]);
    t.per_y[i] = static_cast<float>(warp.to_from_pixel[1][i]);
    t.per_disparity[i] = static_cast<float>(warp.per_disparity[i]);
  }
  return t;
}

HWY_EXPORT(warpBatch);

void warpBatch(const TileTransform& transform, std::span<const LdiSample> samples,
               WarpedBatch& out) noexcept {
  HWY_DYNAMIC_DISPATCH(warpBatch)(transform, samples.data(), samples.size(), out);
}

}  // namespace enfilade
#endif
