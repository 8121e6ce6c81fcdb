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

/// Returns how many of samples [begin, end) do.
HWY_INLINE std::size_t placePatches(const TileTransform& transform, const StoredTransform& t,
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
  std::size_t n = 0;
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
    n += hn::CompressStore(color, hn::RebindMask(DU(), use), DU(), out.color + n);
  }
  return n;
}

/// Four pixels of a row, or two with 16 bits a channel.
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Sums2 = std::uint16_t __attribute__((vector_size(16)));

template <class V, class T>
HWY_INLINE V load(const T* from) {
  V v;
  std::memcpy(&v, from, sizeof(v));
  return v;
}
template <class V, class T>
HWY_INLINE void store(const V& v, T* to) {
  std::memcpy(to, &v, sizeof(v));
}

/// Adds a sample's colour to two pixels where `use`, forgetting what was there where `front`.
HWY_INLINE void addToSums(Sums2 color, Int4 use, Int4 front, std::uint64_t* sums) {
  constexpr std::uint16_t kMost = 256;  // of which sixteen bits hold the sum
  const Sums2 before = load<Sums2>(sums);
  const Sums2 counts = __builtin_shufflevector(before, before, 3, 3, 3, 3, 7, 7, 7, 7);
  const Sums2 has_room = (Sums2)(counts < kMost) | (Sums2)front;
  store<Sums2>((before & ~(Sums2)front) + (color & (Sums2)use & has_room), sums);
}

/// Adds a sample to the means of columns [x0, x1) of a row.  Reads and writes back up to three
/// pixels more.
HWY_INLINE void addToMeans(Sums2 color, float disparity, int x0, int x1, std::uint64_t* sums,
                           float* nearest) {
  const float hidden_from = disparity * R::kSameSurface;
  for (int x = x0; x < x1; x += 4) {
    const auto seen = load<Float4>(nearest + x);
    const Int4 in_row = Int4{0, 1, 2, 3} < x1 - x;
    const Int4 use = (seen <= hidden_from) & in_row;
    const Int4 front = (seen * R::kSameSurface < disparity) & use;
    const Int4 kept = (Int4)seen & ~front;
    store<Int4>(kept | ((Int4)(Float4{} + disparity) & front), nearest + x);
    addToSums(color, __builtin_shufflevector(use, use, 0, 0, 1, 1),
              __builtin_shufflevector(front, front, 0, 0, 1, 1), sums + x);
    addToSums(color, __builtin_shufflevector(use, use, 2, 2, 3, 3),
              __builtin_shufflevector(front, front, 2, 2, 3, 3), sums + x + 2);
  }
}

/// Where a sample lies on a row of pixels.
struct RowPlace {
  float x, per_half_width;
  float closeness;  ///< what it has of all pixels of the row
  float disparity;
};

/// Puts a sample into columns [x0, x1) of a row where it is nearer to the centre than what is
/// there.
HWY_INLINE void keepNearest(std::uint64_t color, const RowPlace& at, int x0, int x1,
                            std::uint64_t* sums, float* nearest, float* closeness) {
  for (int x = x0; x < x1; ++x) {
    if (at.disparity * R::kSameSurface < nearest[x]) continue;
    const float off = std::abs(static_cast<float>(x) + 0.5f - at.x) * at.per_half_width;
    const float close = at.closeness * (1.0f - off);
    const bool in_front = at.disparity > nearest[x] * R::kSameSurface;
    if (!in_front && close <= closeness[x]) continue;
    sums[x] = color;
    closeness[x] = close;
    if (in_front) nearest[x] = at.disparity;
  }
}

/// Lays patch i on its pixels.
template <Splat kSplat>
HWY_INLINE void layPatch(const PatchBatch& batch, std::size_t i, const WarpWindow& window) {
  const std::uint64_t rgb = batch.color[i];
  const std::uint64_t color =
      (rgb & 255u) | (rgb >> 8 & 255u) << 16 | (rgb >> 16 & 255u) << 32 | std::uint64_t{1} << 48;
  const std::uint64_t pair[2] = {color, color};
  const auto colors = load<Sums2>(pair);
  const int x0 = batch.x0[i];
  const int x1 = batch.x1[i];
  for (int y = batch.y0[i]; y < batch.y1[i]; ++y) {
    const std::ptrdiff_t row = y * window.stride;
    if constexpr (kSplat == Splat::kSized) {
      std::fill(window.painted + row + x0, window.painted + row + x1, batch.color[i] | 0xff000000u);
    } else if constexpr (kSplat == Splat::kMean) {
      addToMeans(colors, batch.disparity[i], x0, x1, window.sums + row, window.nearest + row);
    } else {
      const float off = std::abs(static_cast<float>(y) + 0.5f - batch.y[i]);
      const RowPlace place{batch.x[i], batch.per_half_width[i],
                           1.0f - off * batch.per_half_height[i], batch.disparity[i]};
      keepNearest(color, place, x0, x1, window.sums + row, window.nearest + row,
                  window.closeness + row);
    }
  }
}

template <Splat kSplat>
void lay(const TileTransform& transform, const LdiSample* samples, std::size_t count,
         const WarpWindow& window) {
  const StoredTransform t(transform);
  const WarpWindow to = window;  // which no pixel can be taken for a part of
  PatchBatch batch;
  for (std::size_t at = 0; at < count; at += kLayBatch) {
    const std::size_t n =
        placePatches(transform, t, samples, at, std::min(count, at + kLayBatch), to, batch);
    for (std::size_t i = 0; i < n; ++i) layPatch<kSplat>(batch, i, to);
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
      return lay<Splat::kMean>(t, samples, count, window);
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
