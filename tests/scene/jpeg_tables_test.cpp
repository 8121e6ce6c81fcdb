#include "scene/jpeg_tables.h"

#include <algorithm>

#include "scene/image.h"
#include "scene_test_tools.h"

namespace enfilade {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes jpeg() { return encodeJpeg({8, 8, Bytes(std::size_t{4} * 8 * 8, 100)}, 50); }

/// Where a segment begins.
std::size_t placeOf(const Bytes& bytes, std::uint8_t marker) {
  const Bytes words{0xff, marker};
  const auto found = std::search(bytes.begin(), bytes.end(), words.begin(), words.end());
  EXPECT_NE(found, bytes.end());
  return static_cast<std::size_t>(found - bytes.begin());
}

/// Without the segment, though all others stay.
Bytes without(Bytes bytes, std::uint8_t marker) {
  const std::size_t at = placeOf(bytes, marker);
  const std::size_t length = std::size_t{bytes[at + 2]} << 8 | bytes[at + 3];
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(at);
  bytes.erase(begin, begin + static_cast<std::ptrdiff_t>(2 + length));
  return bytes;
}

void expectRefused(const Bytes& bytes) {
  EXPECT_FALSE(hasSoundJpegTables(bytes));
  expectError([&] { decodeImage(bytes, "a.jpg"); }, ErrorKind::kBadInput, "a.jpg",
              "a table that it needs is damaged or not there");
}

TEST(JpegTables, OfAWholeFileAreSound) {
  EXPECT_TRUE(hasSoundJpegTables(jpeg()));
  EXPECT_EQ(decodeImage(jpeg(), "a.jpg").width, 8);
}

TEST(JpegTables, ThatAreMissingAreRefused) {
  expectRefused(without(jpeg(), 0xc4));
  expectRefused(without(jpeg(), 0xdb));
}

TEST(JpegTables, ThatAScanAloneNamesAreRefused) {
  Bytes bytes = jpeg();
  bytes[placeOf(bytes, 0xda) + 6] = 0x33;  // of the first component: both tables 3
  expectRefused(bytes);
}

TEST(JpegTables, WithMoreCodesThanThereCanBeAreRefused) {
  Bytes bytes = jpeg();
  bytes[placeOf(bytes, 0xc4) + 5] = 0xff;  // codes of one bit
  bytes[placeOf(bytes, 0xc4) + 6] = 0xff;
  expectRefused(bytes);
}

TEST(JpegTables, AreNotLookedForInTheBitsOfAScan) {
  Bytes bytes = jpeg();
  bytes.insert(bytes.end() - 2, {0xff, 0x00, 0xff, 0xd0, 0xff});
  EXPECT_TRUE(hasSoundJpegTables(bytes));
}

}  // namespace
}  // namespace enfilade
