#include "render/font.h"

#include <gtest/gtest.h>

#include <numeric>
#include <string>

namespace enfilade {
namespace {

long inkOf(const Glyph& glyph) {
  return std::accumulate(glyph.coverage.begin(), glyph.coverage.end(), 0L);
}

TEST(Font, ATallerLetterHasMoreInk) {
  Font font(20);
  EXPECT_GT(inkOf(font.glyph('l')), 0);
  EXPECT_GT(inkOf(font.glyph('M')), inkOf(font.glyph('l')));
  EXPECT_EQ(inkOf(font.glyph(' ')), 0);
}

TEST(Font, BoldHasMoreInk) {
  Font regular(20), bold(20, FontFace::kBold);
  EXPECT_GT(inkOf(bold.glyph('M')), inkOf(regular.glyph('M')));
}

TEST(Font, ALineIsAsWideAsWhereItsGlyphsEnd) {
  Font font(16);
  const std::string text = "AVA 12.5 ms";
  float end = 0;
  font.layOut(text, {0, 0}, [&](char32_t, const Glyph& glyph, const glm::ivec2& at) {
    end = static_cast<float>(at.x - glyph.offset.x) + glyph.advance;
  });
  EXPECT_NEAR(font.width(text), end, 0.51f);
}

TEST(Font, EveryGlyphOfALineLiesBetweenItsTopAndTheNextLine) {
  Font font(16);
  font.layOut("Agjpqy|({Ö", {5, 100}, [&](char32_t c, const Glyph& glyph, const glm::ivec2& at) {
    EXPECT_GE(at.y, 100) << static_cast<unsigned>(c);
    EXPECT_LE(static_cast<float>(at.y + glyph.size.y), 100 + font.lineHeight() + 1)
        << static_cast<unsigned>(c);
  });
}

TEST(Font, Utf8IsOneGlyphACharacter) {
  Font font(16);
  std::u32string seen;
  font.layOut("aé→𝄞", {0, 0}, [&](char32_t c, const Glyph&, const glm::ivec2&) { seen += c; });
  EXPECT_EQ(seen, U"aé→𝄞");
}

TEST(Font, BytesThatAreNoUtf8AreTheReplacementCharacter) {
  Font font(16);
  std::u32string seen;
  const auto note = [&](char32_t c, const Glyph&, const glm::ivec2&) { seen += c; };
  font.layOut("a\xff\x80\xe2\x82", {0, 0}, note);
  EXPECT_EQ(seen, U"a\ufffd\ufffd\ufffd\ufffd");
  EXPECT_EQ(font.width(""), 0);
}

}  // namespace
}  // namespace enfilade
