#include "ibr/mean_colors.h"

#include <array>
#include <cstring>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "ibr/mean_colors.cpp"
#include <hwy/foreach_target.h>  // compiles this file once for each instruction set
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace enfilade::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Channels = std::uint16_t __attribute__((vector_size(8)));
using Bytes = std::uint8_t __attribute__((vector_size(4)));
using Int4 = std::int32_t __attribute__((vector_size(16)));
using Float4 = float __attribute__((vector_size(16)));

/// `shares`: the reciprocal of every number of samples.
std::size_t meanColors(const std::uint64_t* sums, std::size_t count, const float* shares,
                       std::uint8_t* rgba) {
  std::size_t empty = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t samples = sums[i] >> 48;
    Channels channels;
    std::memcpy(&channels, sums + i, sizeof(channels));
    const Int4 wide = __builtin_convertvector(channels, Int4);
    const Float4 mean = __builtin_convertvector(wide, Float4) * shares[samples] + 0.5f;
    const Bytes bytes = __builtin_convertvector(__builtin_convertvector(mean, Int4), Bytes);
    std::uint32_t pixel;
    std::memcpy(&pixel, &bytes, sizeof(pixel));
    pixel = samples > 0 ? pixel | 0xff000000u : 0u;
    std::memcpy(rgba + 4 * i, &pixel, sizeof(pixel));
    empty += samples == 0;
  }
  return empty;
}

bool mayHoldCracks(const float* nearest, std::ptrdiff_t stride, std::size_t count, float ratio) {
  const hn::ScalableTag<float> df;
  const auto by = hn::Set(df, ratio);
  for (std::size_t i = 0; i < count; i += hn::Lanes(df)) {
    const float* const at = nearest + i;
    const auto behind = hn::Mul(hn::LoadU(df, at), by);
    const auto nearer = [&](std::ptrdiff_t offset) {
      return hn::And(hn::Gt(hn::LoadU(df, at - offset), behind),
                     hn::Gt(hn::LoadU(df, at + offset), behind));
    };
    const auto either = hn::And(hn::Or(nearer(1), nearer(stride)), hn::FirstN(df, count - i));
    if (!hn::AllFalse(df, either)) return true;
  }
  return false;
}

}  // namespace enfilade::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace enfilade {
namespace {

/// A pixel holds 256 samples at the most.
constexpr std::size_t kCounts = 257;

const std::array<float, kCounts> kShares = [] {
  std::array<float, kCounts> shares{};
  for (std::size_t i = 1; i < kCounts; ++i) shares[i] = 1.0f / static_cast<float>(i);
  return shares;
}();

}  // namespace

HWY_EXPORT(meanColors);
HWY_EXPORT(mayHoldCracks);

std::size_t meanColors(const std::uint64_t* sums, std::size_t count, std::uint8_t* rgba) noexcept {
  return HWY_DYNAMIC_DISPATCH(meanColors)(sums, count, kShares.data(), rgba);
}

bool mayHoldCracks(const float* nearest, std::ptrdiff_t stride, std::size_t count,
                   float ratio) noexcept {
  return HWY_DYNAMIC_DISPATCH(mayHoldCracks)(nearest, stride, count, ratio);
}

}  // namespace enfilade
#endif
