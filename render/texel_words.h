#pragma once

#include <cstdint>
#include <cstring>

namespace enfilade {

/// The four channels of an RGBA8 texel in the four 16-bit parts of a word, the first lowest, so
/// that one addition or multiplication works on all of them.
inline std::uint64_t texelWord(const std::uint8_t* texel) noexcept {
  std::uint32_t packed = 0;
  std::memcpy(&packed, texel, sizeof(packed));
  std::uint64_t wide = packed;
  wide = (wide | wide << 16) & 0x0000ffff0000ffffULL;
  return (wide | wide << 8) & 0x00ff00ff00ff00ffULL;
}

/// The texel of the low 8 bits of each part.
inline void storeTexelWord(std::uint64_t word, std::uint8_t* texel) noexcept {
  const std::uint64_t pairs = word | word >> 8;
  const auto packed = static_cast<std::uint32_t>((pairs & 0xffff) | (pairs >> 16 & 0xffff0000));
  std::memcpy(texel, &packed, sizeof(packed));
}

}  // namespace enfilade
