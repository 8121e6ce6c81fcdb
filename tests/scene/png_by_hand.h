#pragma once

#include <zlib.h>

#include <cstdint>
#include <vector>

#include "scene/image.h"

namespace enfilade {

/// A PNG that says it is `side` × `side` pixels of `depth` bits and colour type `color`, whatever
/// `data`, what its compressed data come to, are; without checksums, which no reader of ours minds.
inline std::vector<std::uint8_t> pngByHand(std::uint16_t side, std::uint8_t depth,
                                           std::uint8_t color,
                                           const std::vector<std::uint8_t>& data) {
  std::vector<std::uint8_t> png = encodePng({1, 1, {0, 0, 0, 255}});
  png.resize(33);  // signature and header
  for (const std::size_t at : {18u, 22u}) {
    png[at] = static_cast<std::uint8_t>(side >> 8);
    png[at + 1] = static_cast<std::uint8_t>(side);
  }
  png[24] = depth;
  png[25] = color;
  uLongf length = compressBound(data.size());
  std::vector<std::uint8_t> packed(length);
  compress2(packed.data(), &length, data.data(), data.size(), 9);
  for (int shift = 24; shift >= 0; shift -= 8) {
    png.push_back(static_cast<std::uint8_t>(length >> shift));
  }
  for (const char c : {'I', 'D', 'A', 'T'}) png.push_back(static_cast<std::uint8_t>(c));
  png.insert(png.end(), packed.begin(), packed.begin() + static_cast<std::ptrdiff_t>(length));
  png.insert(png.end(), {0, 0, 0, 0, 0, 0, 0, 0, 'I', 'E', 'N', 'D', 0, 0, 0, 0});
  return png;
}

}  // namespace enfilade
