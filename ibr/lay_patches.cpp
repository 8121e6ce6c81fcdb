// Patches of surface on pixels: splats as large as they appear, of the nearest surface alone.
#include "ibr/lay_patches.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ibr/lay_patches.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set

#include "ibr/warp_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::HWY_NAMESPACE {

using R = FootprintRules;

inline constexpr std::size_t kLayBatch = 128;
inline constexpr std::size_t kLayRoom = kLayBatch + hn::MaxLanes(DU());

/// The patches of a batch of samples that cover pixels of the window: columns [x0, x1), rows [y0,
/// y1), not empty.
struct PatchBatch {
  std::size_t count = 0;
  HWY_ALIGN std::int32_t x0[kLayRoom], x1[kLayRoom], y0[kLayRoom], y1[kLayRoom];
  HWY_ALIGN float x[kLayRoom], y[kLayRoom], disparity[kLayRoom];
  HWY_ALIGN float per_half_width[kLayRoom], per_half_height[kLayRoom];
  HWY_ALIGN std::uint32_t color[kLayRoom];
};

/// The first pixels within [first, beyond] whose centres are at or beyond `edge`.
HWY_INLINE VF firstCentersFrom(VF edge, VF first, VF beyond) {
  const VF kept = hn::Min(hn::Max(first, edge), beyond);
  return hn::Ceil(hn::Sub(kept, hn::Set(DF(), 0.5f)));
}

HWY_INLINE VF footprint(VF half) {
  const DF df;
  const VF larger = hn::Mul(hn::Set(df, R::kScale), half);
  return hn::Min(hn::Max(hn::Set(df, R::kLeastHalf), larger), hn::Set(df, R::kGreatestHalf));
}

HWY_INLINE void placePatches(const TileTransform& transform, const StoredTransform& t,
                             const LdiSample* samples, std::size_t begin, std::size_t end,
                             const WarpWindow& window, PatchBatch& out) {
  const DF df;
  const DI di;
  const VF left = hn::Set(df, static_cast<float>(window.left));
  const VF top = hn::Set(df, static_cast<float>(window.top));
  const VF right = hn::Set(df, static_cast<float>(window.right));
  const VF bottom = hn::Set(df, static_cast<float>(window.bottom));
  const VF far = hn::Set(df, 1e7f);  // so that none of what follows overflows
  const VF one = hn::Set(df, 1.0f);
  out.count = 0;
  for (std::size_t i = begin; i < end; i += hn::Lanes(df)) {
    VU color, stored;
    loadSamples(samples, i, end, color, stored);
    const WarpedLanes at = warpLanes(t, stored);
    VF across, down;
    halfPatches(color, at.scale, across, down);
    const VF half_width = footprint(halfFootprint(transform, 0, at.x, across, down));
    const VF half_height = footprint(halfFootprint(transform, 1, at.y, across, down));
    const VF x0 = firstCentersFrom(hn::Sub(at.x, half_width), left, right);
    const VF x1 = firstCentersFrom(hn::Add(at.x, half_width), left, right);
    const VF y0 = firstCentersFrom(hn::Sub(at.y, half_height), top, bottom);
    const VF y1 = firstCentersFrom(hn::Add(at.y, half_height), top, bottom);
    auto use = hn::And(hn::Gt(at.scale, hn::Zero(df)), hn::Lt(at.scale, far));
    use = hn::And(use, hn::And(hn::Lt(hn::Abs(at.x), far), hn::Lt(hn::Abs(at.y), far)));
    use = hn::And(use, hn::And(hn::Lt(x0, x1), hn::Lt(y0, y1)));
    use = hn::And(use, hn::FirstN(df, end - i));
    const std::size_t n = out.count;
    const auto keepInts = [&](VF v, std::int32_t* to) {
      hn::CompressStore(hn::ConvertTo(di, v), hn::RebindMask(di, use), di, to + n);
    };
    const auto keep = [&](VF v, float* to) { hn::CompressStore(v, use, df, to + n); };
    keepInts(x0, out.x0);
    keepInts(x1, out.x1);
    keepInts(y0, out.y0);
    keepInts(y1, out.y1);
    keep(at.x, out.x);
    keep(at.y, out.y);
    keep(at.disparity, out.disparity);
    keep(hn::Div(one, half_width), out.per_half_width);
    keep(hn::Div(one, half_height), out.per_half_height);
    out.count += hn::CompressStore(color, hn::RebindMask(DU(), use), DU(), out.color + n);
  }
}

/// Four floats that are added and multiplied at once.
using Float4 = float __attribute__((vector_size(16)));

HWY_INLINE Float4 load(const glm::vec4& v) {
  Float4 f;
  std::memcpy(&f, &v, sizeof(f));
  return f;
}
HWY_INLINE void store(Float4 f, glm::vec4& to) { std::memcpy(&to, &f, sizeof(f)); }

/// Adds patch i to a row of pixels; `row_weight` is what its weights have in common there.
template <Splat kSplat>
HWY_INLINE void layRow(const PatchBatch& batch, std::size_t i, float row_weight, Float4 color,
                       glm::vec4* weighted, float* nearest) {
  const float disparity = batch.disparity[i];
  const float hidden_from = disparity * R::kSameSurface;
  for (int x = batch.x0[i]; x < batch.x1[i]; ++x) {
    const float seen = nearest[x];
    if (hidden_from < seen) continue;
    const float off =
        1.0f - std::abs(static_cast<float>(x) + 0.5f - batch.x[i]) * batch.per_half_width[i];
    const float weight = row_weight * (off * off + R::kLeastWeight);
    const bool in_front = disparity > seen * R::kSameSurface;
    if constexpr (kSplat == Splat::kNearest) {
      if (in_front || weight > weighted[x].w) store(weight * color, weighted[x]);
    } else {
      const Float4 before = in_front ? Float4{} : load(weighted[x]);
      store(before + weight * color, weighted[x]);
    }
    nearest[x] = in_front ? disparity : seen;
  }
}

/// Lays patch i on its pixels.
template <Splat kSplat>
HWY_INLINE void layPatch(const PatchBatch& batch, std::size_t i, const WarpWindow& window) {
  const std::uint32_t rgb = batch.color[i];
  const Float4 color = {static_cast<float>(static_cast<int>(rgb & 255u)),
                        static_cast<float>(static_cast<int>(rgb >> 8 & 255u)),
                        static_cast<float>(static_cast<int>(rgb >> 16 & 255u)), 1.0f};
  for (int y = batch.y0[i]; y < batch.y1[i]; ++y) {
    const std::ptrdiff_t row = y * window.stride;
    if constexpr (kSplat == Splat::kSized) {
      std::fill(window.painted + row + batch.x0[i], window.painted + row + batch.x1[i],
                rgb | 0xff000000u);
    } else {
      const float off =
          1.0f - std::abs(static_cast<float>(y) + 0.5f - batch.y[i]) * batch.per_half_height[i];
      layRow<kSplat>(batch, i, off * off + R::kLeastWeight, color, window.weighted + row,
                     window.nearest + row);
    }
  }
}

template <Splat kSplat>
void lay(const TileTransform& transform, const LdiSample* samples, std::size_t count,
         const WarpWindow& window) {
  const StoredTransform t(transform);
  PatchBatch batch;
  for (std::size_t at = 0; at < count; at += kLayBatch) {
    placePatches(transform, t, samples, at, std::min(count, at + kLayBatch), window, batch);
    for (std::size_t i = 0; i < batch.count; ++i) layPatch<kSplat>(batch, i, window);
  }
}

void layPatches(Splat splat, const TileTransform& t, const LdiSample* samples, std::size_t count,
                const WarpWindow& window) {
  switch (splat) {
    case Splat::kSized:
      return lay<Splat::kSized>(t, samples, count, window);
    case Splat::kNearest:
      return lay<Splat::kNearest>(t, samples, count, window);
    default:
      return lay<Splat::kBlend>(t, samples, count, window);
  }
}

}  // namespace enfilade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace enfilade {

HWY_EXPORT(layPatches);

void layPatches(Splat splat, const TileTransform& transform, std::span<const LdiSample> samples,
                const WarpWindow& window) noexcept {
  HWY_DYNAMIC_DISPATCH(layPatches)(splat, transform, samples.data(), samples.size(), window);
}

}  // namespace enfilade
#endif
