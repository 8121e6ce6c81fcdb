#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

namespace enfilade {

enum class FontFace : std::uint8_t { kRegular, kBold };

/// How a character looks at one size.
struct Glyph {
  glm::ivec2 size{0};                  ///< [pixels]
  glm::ivec2 offset{0};                ///< of its upper left corner from the pen, y down
  float advance = 0;                   ///< [pixels] of the pen
  std::vector<std::uint8_t> coverage;  ///< size.x × size.y, row 0 on top; 255 is all ink
};

/// DejaVu Sans at one size, the same on every machine: it is part of the program.
/// Glyphs are made when they are first asked for, and kept.
class Font {
 public:
  /// `pixels`: from the top of a line's letters to the bottom of their tails.
  explicit Font(float pixels, FontFace face = FontFace::kRegular);
  ~Font();
  Font(const Font&) = delete;
  Font& operator=(const Font&) = delete;

  float ascent() const noexcept { return ascent_; }    ///< [pixels] of the baseline below the top
  float lineHeight() const noexcept { return line_; }  ///< [pixels] from a line to the next

  /// A box for characters that the font does not have.
  const Glyph& glyph(char32_t character);

  /// Width of a line of UTF-8 text [pixels].
  float width(std::string_view text);

  /// Calls `place` for each glyph of a line of UTF-8 text whose upper left corner is `at`: with
  /// its upper left pixel, on whole pixels so that stems stay sharp.  Bytes that are no UTF-8
  /// show as boxes.
  void layOut(std::string_view text, const glm::vec2& at,
              const std::function<void(char32_t, const Glyph&, const glm::ivec2&)>& place);

 private:
  float kerning(char32_t left, char32_t right) const;

  struct Outlines;
  std::unique_ptr<Outlines> outlines_;
  float scale_ = 1;  // pixels a unit of the font
  float ascent_ = 0, line_ = 0;
  std::map<char32_t, Glyph> glyphs_;
};

}  // namespace enfilade
