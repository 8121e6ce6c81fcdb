#include "render/font.h"

#include <stb_truetype.h>

#include <cassert>
#include <cmath>

#include "render/font_files.h"

namespace enfilade {

namespace {

/// Takes the first character off `text`; U+FFFD for a byte that begins none.
char32_t takeCharacter(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t lead = byte(0);
  std::size_t length = 1;
  char32_t character = lead;
  if (lead >= 0xc2 && lead < 0xe0) {
    length = 2;
    character = lead & 0x1fu;
  } else if (lead >= 0xe0 && lead < 0xf0) {
    length = 3;
    character = lead & 0x0fu;
  } else if (lead >= 0xf0 && lead < 0xf5) {
    length = 4;
    character = lead & 0x07u;
  } else if (lead >= 0x80) {
    text.remove_prefix(1);
    return 0xfffd;
  }
  for (std::size_t i = 1; i < length; ++i) {
    if (i >= text.size() || (byte(i) & 0xc0u) != 0x80u) {
      text.remove_prefix(1);
      return 0xfffd;
    }
    character = (character << 6) | (byte(i) & 0x3fu);
  }
  text.remove_prefix(length);
  return character;
}

}  // namespace

struct Font::Outlines {
  stbtt_fontinfo info;
};

Font::Font(float pixels, FontFace face) : outlines_(std::make_unique<Outlines>()) {
  const std::string_view file = face == FontFace::kBold ? kBoldFont : kRegularFont;
  const auto* bytes = reinterpret_cast<const unsigned char*>(file.data());  // NOLINT
  stbtt_fontinfo& info = outlines_->info;
  [[maybe_unused]] const int read = stbtt_InitFont(&info, bytes, 0);
  assert(read != 0 && "the font is part of the program");
  int ascent = 0, descent = 0, gap = 0;
  stbtt_GetFontVMetrics(&info, &ascent, &descent, &gap);
  scale_ = stbtt_ScaleForPixelHeight(&info, pixels);
  ascent_ = std::round(scale_ * static_cast<float>(ascent));
  line_ = std::round(scale_ * static_cast<float>(ascent - descent + gap));
}

Font::~Font() = default;

const Glyph& Font::glyph(char32_t character) {
  const auto [found, added] = glyphs_.try_emplace(character);
  Glyph& glyph = found->second;
  if (!added) return glyph;
  const stbtt_fontinfo& info = outlines_->info;
  const int code = static_cast<int>(character);
  int advance = 0, bearing = 0, x1 = 0, y1 = 0;
  stbtt_GetCodepointHMetrics(&info, code, &advance, &bearing);
  stbtt_GetCodepointBitmapBox(&info, code, scale_, scale_, &glyph.offset.x, &glyph.offset.y, &x1,
                              &y1);
  glyph.advance = scale_ * static_cast<float>(advance);
  glyph.size = glm::ivec2(x1, y1) - glyph.offset;
  glyph.coverage.resize(static_cast<std::size_t>(glyph.size.x) *
                        static_cast<std::size_t>(glyph.size.y));
  if (!glyph.coverage.empty()) {
    stbtt_MakeCodepointBitmap(&info, glyph.coverage.data(), glyph.size.x, glyph.size.y,
                              glyph.size.x, scale_, scale_, code);
  }
  return glyph;
}

float Font::kerning(char32_t left, char32_t right) const {
  if (left == 0) return 0;
  return scale_ * static_cast<float>(stbtt_GetCodepointKernAdvance(
                      &outlines_->info, static_cast<int>(left), static_cast<int>(right)));
}

float Font::width(std::string_view text) {
  float pen = 0;
  char32_t last = 0;
  while (!text.empty()) {
    const char32_t character = takeCharacter(text);
    pen += kerning(last, character) + glyph(character).advance;
    last = character;
  }
  return pen;
}

void Font::layOut(std::string_view text, const glm::vec2& at,
                  const std::function<void(char32_t, const Glyph&, const glm::ivec2&)>& place) {
  float pen = at.x;
  const auto baseline = static_cast<int>(std::lround(at.y + ascent_));
  char32_t last = 0;
  while (!text.empty()) {
    const char32_t character = takeCharacter(text);
    pen += kerning(last, character);
    const Glyph& shape = glyph(character);
    place(character, shape,
          glm::ivec2(static_cast<int>(std::lround(pen)), baseline) + shape.offset);
    pen += shape.advance;
    last = character;
  }
}

}  // namespace enfilade
