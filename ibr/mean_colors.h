#pragma once

#include <cstddef>
#include <cstdint>

namespace enfilade {

/// Turns `count` pixels' sums (red, green, blue, number of samples; 16 bits each) into RGBA8: their
/// mean, or 0 where there is no sample.  Returns how many have none.
std::size_t meanColors(const std::uint64_t* sums, std::size_t count, std::uint8_t* rgba) noexcept;

/// Whether any of `count` pixels may be a crack in a nearer surface: whether the pixels before and
/// after it, or `stride` before and after, are all nearer by `ratio` or more.
bool mayHoldCracks(const float* nearest, std::ptrdiff_t stride, std::size_t count,
                   float ratio) noexcept;

}  // namespace enfilade
