// The warp of a vector of samples, for each instruction set that Highway compiles for.
// McMillan & Bishop, Plenoptic Modeling, 1995: linear in (u, v, δ) before the divide.

#if defined(ENFILADE_WARP_LANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef ENFILADE_WARP_LANES_INL_H
#undef ENFILADE_WARP_LANES_INL_H
#else
#define ENFILADE_WARP_LANES_INL_H
#endif

#include <hwy/highway.h>

#include <cstring>

#include "ibr/ldi.h"
#include "ibr/warp_positions.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using DF = hn::ScalableTag<float>;
using DU = hn::RebindToUnsigned<DF>;
using DI = hn::RebindToSigned<DF>;
using VF = hn::Vec<DF>;
using VU = hn::Vec<DU>;

/// A tile's transform for places as they are stored, in eighths of a pixel and steps of disparity.
struct StoredTransform {
  explicit StoredTransform(const TileTransform& t) noexcept {
    constexpr float kDisparityStep = 1.0f / (1 << kDisparityBits);
    for (int i = 0; i < 3; ++i) {
      per_x[i] = kPlaceStep * t.per_x[i];
      per_y[i] = kPlaceStep * t.per_y[i];
      per_disparity[i] = kDisparityStep * t.per_disparity[i];
      origin[i] = t.origin[i] + per_disparity[i];  // disparity 1 is stored as 0
    }
  }
  float origin[3], per_x[3], per_y[3], per_disparity[3];
};

struct WarpedLanes {
  VF x, y;       ///< pixels
  VF scale;      ///< 1 / w; its sign tells what is behind the eye
  VF disparity;  ///< in the desired image
};

HWY_INLINE VF linear(const StoredTransform& t, int i, VF u, VF v, VF d) {
  const DF df;
  // Multiplied and added apart: the same positions on machines with and without a fused operation.
  const VF along =
      hn::Add(hn::Mul(u, hn::Set(df, t.per_x[i])), hn::Mul(v, hn::Set(df, t.per_y[i])));
  return hn::Add(hn::Add(hn::Set(df, t.origin[i]), along),
                 hn::Mul(d, hn::Set(df, t.per_disparity[i])));
}

HWY_INLINE VF toFloat(VU v) { return hn::ConvertTo(DF(), hn::BitCast(DI(), v)); }

/// Where samples at `place` fall.
HWY_INLINE WarpedLanes warpLanes(const StoredTransform& t, VU place) {
  const DF df;
  const VU mask = hn::Set(DU(), (1u << kPlaceBits) - 1u);
  const VF u = toFloat(hn::And(place, mask));
  const VF v = toFloat(hn::And(hn::ShiftRight<kPlaceBits>(place), mask));
  const VF d = toFloat(hn::ShiftRight<2 * kPlaceBits>(place));
  WarpedLanes out;
  out.scale = hn::Div(hn::Set(df, 1.0f), linear(t, 2, u, v, d));
  out.x = hn::Mul(linear(t, 0, u, v, d), out.scale);
  out.y = hn::Mul(linear(t, 1, u, v, d), out.scale);
  constexpr float kDisparityStep = 1.0f / (1 << kDisparityBits);
  const VF disparity = hn::Mul(hn::Add(d, hn::Set(df, 1.0f)), hn::Set(df, kDisparityStep));
  out.disparity = hn::Mul(disparity, out.scale);
  return out;
}

/// footprintSize() without a table: 2^(code / 2 − 2).
HWY_INLINE VF footprintSizes(VU code) {
  const DF df;
  const DU du;
  const VF power =
      hn::BitCast(df, hn::ShiftLeft<23>(hn::Add(hn::ShiftRight<1>(code), hn::Set(du, 125u))));
  const VF odd = toFloat(hn::And(code, hn::Set(du, 1u)));
  return hn::Mul(power, hn::Add(hn::Set(df, 1.0f), hn::Mul(hn::Set(df, 0.41421356f), odd)));
}

/// Half the width (axis 0) or height (axis 1) of the box of the samples' footprints [pixels], at
/// `at` on that axis.
HWY_INLINE VF halfFootprint(const TileTransform& t, int axis, VF at, VF across, VF down) {
  const DF df;
  const auto side = [&](const float* per) {
    return hn::Abs(hn::Sub(hn::Set(df, per[axis]), hn::Mul(at, hn::Set(df, per[2]))));
  };
  return hn::Add(hn::Mul(side(t.per_x), across), hn::Mul(side(t.per_y), down));
}

/// Half the sides of the samples' patches, across and down, times 1 / w.
HWY_INLINE void halfPatches(VU color, VF scale, VF& across, VF& down) {
  const DF df;
  const VF half = hn::Mul(hn::Set(df, 0.5f), scale);
  across = hn::Mul(footprintSizes(hn::ShiftRight<28>(color)), half);
  down = hn::Mul(footprintSizes(hn::And(hn::ShiftRight<24>(color), hn::Set(DU(), 15u))), half);
}

/// Samples [at, …) of `count`, as many as there are lanes: colour and footprint, and place; those
/// beyond are 0.
HWY_INLINE void loadSamples(const LdiSample* samples, std::size_t at, std::size_t count, VU& color,
                            VU& place) {
  const DU du;
  const std::size_t lanes = hn::Lanes(du);
  if (at + lanes <= count) {
    hn::LoadInterleaved2(du, reinterpret_cast<const std::uint32_t*>(samples + at), color, place);
    return;
  }
  HWY_ALIGN std::uint32_t padded[2 * hn::MaxLanes(DU())] = {};
  std::memcpy(padded, samples + at, (count - at) * sizeof(LdiSample));
  hn::LoadInterleaved2(du, padded, color, place);
}

}  // namespace enfilade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
