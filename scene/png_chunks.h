#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>

namespace enfilade {

/// Calls take(type, content) for each chunk of a PNG before its end, `type` its four letters, until
/// that returns false.  False if a chunk says that it is longer than what is left.
template <typename Take>
bool forEachPngChunk(std::span<const std::uint8_t> png, Take&& take) {
  constexpr std::size_t kSignature = 8, kHead = 8, kChecksum = 4;
  std::span<const std::uint8_t> rest = png.subspan(std::min(kSignature, png.size()));
  while (rest.size() >= kHead) {
    const std::size_t length = std::size_t{rest[0]} << 24 | std::size_t{rest[1]} << 16 |
                               std::size_t{rest[2]} << 8 | std::size_t{rest[3]};
    const auto* type = reinterpret_cast<const char*>(&rest[4]);
    if (std::memcmp(type, "IEND", 4) == 0) return true;
    if (length > rest.size() - kHead) return false;
    if (!take(type, rest.subspan(kHead, length))) return true;
    rest = rest.subspan(std::min(kHead + length + kChecksum, rest.size()));
  }
  return true;
}

}  // namespace enfilade
