// Rafferty et al., Images for Accelerating Architectural Walkthroughs, 1998, sec. 3.1.
#include "ibr/paint_splats.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ibr/paint_splats.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set

#include "ibr/warp_lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace enfilade::HWY_NAMESPACE {

HWY_INLINE void storePair(std::uint32_t* at, std::uint64_t pair) {
  std::memcpy(at, &pair, sizeof(pair));
}

/// Squares of kSide pixels.
template <int kSize>
struct Square {
  static constexpr int kSide = kSize;
  static HWY_INLINE void store(std::uint32_t* at, std::ptrdiff_t stride, std::uint32_t color) {
    const std::uint64_t pair = std::uint64_t{color} << 32 | color;
    for (int row = 0; row < kSide; ++row, at += stride) {
      if constexpr (kSide == 1) *at = color;
      if constexpr (kSide >= 2) storePair(at, pair);
      if constexpr (kSide == 3) at[2] = color;
    }
  }
};

struct Cross {
  static constexpr int kSide = 3;
  static HWY_INLINE void store(std::uint32_t* at, std::ptrdiff_t stride, std::uint32_t color) {
    at[1] = color;
    storePair(at + stride, std::uint64_t{color} << 32 | color);
    at[stride + 2] = color;
    at[2 * stride + 1] = color;
  }
};

inline constexpr std::size_t kPaintBatch = 256;

/// What falls into the window, of a batch of samples: where the splat's first pixel is, and colour.
struct PaintBatch {
  HWY_ALIGN std::int32_t first[kPaintBatch + hn::MaxLanes(DU())];
  HWY_ALIGN std::uint32_t color[kPaintBatch + hn::MaxLanes(DU())];
};

/// Returns how many of samples [begin, end) fall into the window.
template <class Shape>
HWY_INLINE std::size_t place(const StoredTransform& t, const LdiSample* samples, std::size_t begin,
                             std::size_t end, const WarpWindow& window, PaintBatch& out) {
  const DF df;
  const DI di;
  const VF back = hn::Set(df, 0.5f * (Shape::kSide - 1));
  const VF left = hn::Set(df, static_cast<float>(window.left - Shape::kSide + 1));
  const VF top = hn::Set(df, static_cast<float>(window.top - Shape::kSide + 1));
  const VF right = hn::Set(df, static_cast<float>(window.right));
  const VF bottom = hn::Set(df, static_cast<float>(window.bottom));
  const auto stride = hn::Set(di, static_cast<std::int32_t>(window.stride));
  const VU opaque = hn::Set(DU(), 0xff000000u);
  std::size_t n = 0;
  for (std::size_t i = begin; i < end; i += hn::Lanes(df)) {
    VU color, stored;
    loadSamples(samples, i, end, color, stored);
    const WarpedLanes lanes = warpLanes(t, stored);
    const VF x = hn::Floor(hn::Sub(lanes.x, back));
    const VF y = hn::Floor(hn::Sub(lanes.y, back));
    auto inside = hn::And(hn::And(hn::Ge(x, left), hn::Lt(x, right)),
                          hn::And(hn::Ge(y, top), hn::Lt(y, bottom)));
    inside = hn::And(inside, hn::Gt(lanes.scale, hn::Zero(df)));
    inside = hn::And(inside, hn::FirstN(df, end - i));
    const auto first = hn::Add(hn::Mul(hn::ConvertTo(di, y), stride), hn::ConvertTo(di, x));
    hn::CompressStore(first, hn::RebindMask(di, inside), di, out.first + n);
    n +=
        hn::CompressStore(hn::Or(color, opaque), hn::RebindMask(DU(), inside), DU(), out.color + n);
  }
  return n;
}

template <class Shape>
void paint(const TileTransform& transform, const LdiSample* samples, std::size_t count,
           const WarpWindow& window) {
  const StoredTransform t(transform);
  // Copies, as the painted pixels might be taken for what these are read from.
  std::uint32_t* const painted = window.painted;
  const std::ptrdiff_t stride = window.stride;
  PaintBatch batch;
  for (std::size_t at = 0; at < count; at += kPaintBatch) {
    const std::size_t n =
        place<Shape>(t, samples, at, std::min(count, at + kPaintBatch), window, batch);
    for (std::size_t i = 0; i < n; ++i) {
      Shape::store(painted + batch.first[i], stride, batch.color[i]);
    }
  }
}

void paintSplats(Splat splat, const TileTransform& t, const LdiSample* samples, std::size_t count,
                 const WarpWindow& window) {
  switch (splat) {
    case Splat::k1x1:
      return paint<Square<1>>(t, samples, count, window);
    case Splat::k2x2:
      return paint<Square<2>>(t, samples, count, window);
    case Splat::k3x3:
      return paint<Square<3>>(t, samples, count, window);
    default:
      return paint<Cross>(t, samples, count, window);
  }
}

}  // namespace enfilade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace enfilade {

HWY_EXPORT(paintSplats);

void paintSplats(Splat splat, const TileTransform& transform, std::span<const LdiSample> samples,
                 const WarpWindow& window) noexcept {
  HWY_DYNAMIC_DISPATCH(paintSplats)(splat, transform, samples.data(), samples.size(), window);
}

}  // namespace enfilade
#endif
