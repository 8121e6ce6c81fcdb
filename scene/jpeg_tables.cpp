#include "scene/jpeg_tables.h"

#include <array>
#include <numeric>

namespace enfilade {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint8_t kBaseline = 0xc0, kExtended = 0xc1, kProgressive = 0xc2, kHuffman = 0xc4,
                       kEnd = 0xd9, kScan = 0xda, kQuantization = 0xdb;

/// Of the same meaning wherever they stand: no length and no content follow.
bool standsAlone(std::uint8_t marker) {
  return marker <= 0x01 || (marker >= 0xd0 && marker <= 0xd8) || marker == 0xff;
}

/// What a file has told so far.
class JpegTables {
 public:
  /// False if the content of a segment is not as it should be.
  bool take(std::uint8_t marker, Bytes content) {
    switch (marker) {
      case kHuffman:
        return takeHuffman(content);
      case kQuantization:
        return takeQuantization(content);
      case kBaseline:
      case kExtended:
      case kProgressive:
        is_progressive_ = marker == kProgressive;
        return takeFrame(content);
      case kScan:
        return areThereFor(content);
      default:
        return true;
    }
  }

 private:
  static constexpr std::size_t kTables = 4;

  bool takeHuffman(Bytes content) {
    while (!content.empty()) {
      if (content.size() < 17) return false;
      const std::size_t kind = content[0] >> 4, table = content[0] & 15;
      const auto lengths = content.subspan(1, 16);
      const auto codes = std::accumulate(lengths.begin(), lengths.end(), std::size_t{0});
      if (kind > 1 || table >= kTables || codes > 256 || codes > content.size() - 17) return false;
      huffman_[kind][table] = true;
      content = content.subspan(17 + codes);
    }
    return true;
  }

  bool takeQuantization(Bytes content) {
    while (!content.empty()) {
      const std::size_t size = content[0] >> 4 == 0 ? 65 : 129, table = content[0] & 15;
      if (table >= kTables || size > content.size()) return false;
      quantization_[table] = true;
      content = content.subspan(size);
    }
    return true;
  }

  bool takeFrame(Bytes content) {
    if (content.size() < 6 || content.size() < 6 + 3 * std::size_t{content[5]}) return false;
    for (std::size_t i = 0; i < content[5]; ++i) {
      table_of_component_[content[6 + 3 * i]] = content[8 + 3 * i];
    }
    return true;
  }

  /// The tables that a scan names.
  bool areThereFor(Bytes scan) const {
    if (scan.empty() || scan.size() != 4 + 2 * std::size_t{scan[0]}) return false;
    const std::size_t components = scan[0];
    const std::uint8_t first_coefficient = scan[1 + 2 * components];
    const bool is_refinement = scan[3 + 2 * components] >> 4 != 0;
    const bool uses_dc = !is_progressive_ || (first_coefficient == 0 && !is_refinement);
    const bool uses_ac = !is_progressive_ || first_coefficient > 0;
    for (std::size_t i = 0; i < components; ++i) {
      const std::size_t dc = scan[2 + 2 * i] >> 4, ac = scan[2 + 2 * i] & 15;
      const std::size_t quantization = table_of_component_[scan[1 + 2 * i]];
      if (dc >= kTables || ac >= kTables || quantization >= kTables) return false;
      if (uses_dc && !huffman_[0][dc]) return false;
      if (uses_ac && !huffman_[1][ac]) return false;
      if (!quantization_[quantization]) return false;
    }
    return true;
  }

  bool is_progressive_ = false;
  std::array<std::array<bool, kTables>, 2> huffman_{};  // of DC, of AC
  std::array<bool, kTables> quantization_{};
  std::array<std::uint8_t, 256> table_of_component_{};
};

/// Takes the next marker off `rest`, which may stand behind the bits of a scan; false at the end.
bool takeMarker(Bytes& rest, std::uint8_t& marker) {
  while (rest.size() >= 2) {
    const bool found = rest[0] == 0xff && rest[1] != 0x00 && rest[1] != 0xff;
    marker = rest[1];
    rest = rest.subspan(found ? 2 : 1);
    if (found) return true;
  }
  return false;
}

}  // namespace

bool hasSoundJpegTables(Bytes bytes) noexcept {
  JpegTables tables;
  std::uint8_t marker = 0;
  for (Bytes rest = bytes; takeMarker(rest, marker) && marker != kEnd;) {
    if (standsAlone(marker)) continue;
    if (rest.size() < 2) return true;
    const std::size_t length = std::size_t{rest[0]} << 8 | rest[1];
    if (length < 2 || length > rest.size()) return true;  // the decoder says so too
    if (!tables.take(marker, rest.subspan(2, length - 2))) return false;
    rest = rest.subspan(length);
  }
  return true;
}

std::size_t countJpegScans(Bytes bytes) noexcept {
  std::size_t scans = 0;
  std::uint8_t marker = 0;
  for (Bytes rest = bytes; takeMarker(rest, marker);) scans += marker == kScan;
  return scans;
}

}  // namespace enfilade
