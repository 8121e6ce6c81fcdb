#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace enfilade {

/// What a PNG's compressed data come to.
enum class PngInflation : std::uint8_t { kFits, kTooMuch, kDamaged };

/// Whether the data of a PNG, whose chunks are whole, are more than `most` bytes when inflated.
/// Decoders inflate all of it before they look how much the picture needs, and 1 MB may come to 1
/// GB.  Looks no closer where `most` cannot be exceeded by much.  Source: RFC 1950, RFC 1951.
PngInflation inflatePng(std::span<const std::uint8_t> png, std::size_t most);

}  // namespace enfilade
