// McMillan & Bishop, Plenoptic Modeling, 1995: linear in (u, v, δ) before the divide.
#include "ibr/warp_positions.h"

#include <bit>
#include <cmath>

namespace enfilade {
namespace {

/// footprintSize() without a table, so that the loop vectorises: 2^(code / 2 − 2).
inline float footprintSizeOf(unsigned code) noexcept {
  const float power_of_two = std::bit_cast<float>(((code >> 1) + 125u) << 23);
  return power_of_two * (1.0f + 0.41421356f * static_cast<float>(static_cast<int>(code & 1u)));
}

}  // namespace

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

void warpBatch(const TileTransform& transform, std::span<const LdiSample> samples,
               WarpedBatch& out) noexcept {
  const TileTransform t = transform;
  const std::size_t count = samples.size();
  for (std::size_t i = 0; i < count; ++i) {
    const LdiSample& s = samples[i];
    const float u = xInTile(s);
    const float v = yInTile(s);
    const float d = disparityOf(s);
    const float xw = t.origin[0] + u * t.per_x[0] + v * t.per_y[0] + d * t.per_disparity[0];
    const float yw = t.origin[1] + u * t.per_x[1] + v * t.per_y[1] + d * t.per_disparity[1];
    const float w = t.origin[2] + u * t.per_x[2] + v * t.per_y[2] + d * t.per_disparity[2];
    const float scale = 1.0f / w;
    const float x = xw * scale;
    const float y = yw * scale;
    out.x[i] = x;
    out.y[i] = y;
    out.disparity[i] = d * scale;
    const float across = 0.5f * footprintSizeOf(s.footprint >> 4) * scale;
    const float down = 0.5f * footprintSizeOf(s.footprint & 15u) * scale;
    out.half_width[i] = std::abs(t.per_x[0] - x * t.per_x[2]) * across +
                        std::abs(t.per_y[0] - x * t.per_y[2]) * down;
    out.half_height[i] = std::abs(t.per_x[1] - y * t.per_x[2]) * across +
                         std::abs(t.per_y[1] - y * t.per_y[2]) * down;
  }
}

}  // namespace enfilade
