#include "app/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kNameScale = 1.2f;  ///< the name's letters to the figures'
constexpr float kGround = 0.35f;    ///< what is left of the picture under the box
constexpr const char* kGap = "    ";

std::string medianText(const Caption& caption) {
  return fmt::format("median {:.1f} ms", caption.median_ms);
}

/// As wide as the time of a frame gets: digits are all of one width.
const char* widestTime(const Caption& caption) {
  return caption.median_ms < 100 ? "888.8" : "8888.8";
}

/// Letters of 1/24 of the picture, as in subtitles, and smaller where a line would not fit.
float textPixels(const glm::ivec2& panel) {
  const float wanted = std::clamp(static_cast<float>(panel.y) / 24, 13.0f, 48.0f);
  Font font(wanted);
  const float line = font.width(std::string("888.8 ms") + kGap + "median 888.8 ms") + 2 * wanted;
  return std::max(7.0f, wanted * std::min(1.0f, static_cast<float>(panel.x) / line));
}

std::uint8_t mix(std::uint8_t from, float to, float share) {
  return static_cast<std::uint8_t>(
      std::lround(static_cast<float>(from) + share * (to - static_cast<float>(from))));
}

}  // namespace

CaptionPainter::CaptionPainter(const glm::ivec2& panel)
    : panel_(panel),
      figures_(textPixels(panel)),
      name_(kNameScale * textPixels(panel), FontFace::kBold),
      padding_(std::round(0.4f * textPixels(panel))) {}

float CaptionPainter::figuresWidth(const Caption& caption) {
  return figures_.width(widestTime(caption) + std::string(" ms") + kGap + medianText(caption));
}

PixelRange CaptionPainter::box(const Caption& caption) {
  const float text = std::max(name_.width(caption.name), figuresWidth(caption));
  const glm::vec2 size(text, name_.lineHeight() + figures_.lineHeight());
  const glm::ivec2 low(static_cast<int>(padding_));
  const glm::ivec2 high = low + glm::ivec2(glm::ceil(size + 2 * padding_));
  return {glm::min(low, panel_), glm::min(high, panel_)};
}

void CaptionPainter::draw(const Caption& caption, const glm::ivec2& corner, Image& frame) {
  PixelRange within = box(caption);
  within.low += corner;
  within.high += corner;
  for (int y = within.low.y; y < within.high.y; ++y) {
    for (int x = within.low.x; x < within.high.x; ++x) {
      std::uint8_t* pixel = &frame.rgba[4 * static_cast<std::size_t>(y * frame.width + x)];
      for (int c = 0; c < 3; ++c) pixel[c] = mix(pixel[c], 0, 1 - kGround);
    }
  }
  glm::vec2 at = glm::vec2(within.low) + padding_;
  write(name_, caption.name, at, within, frame);
  at.y += name_.lineHeight();
  // From the right, so that the point stands still while the digits change.
  const std::string time = fmt::format("{:.1f}", caption.frame_ms);
  const float column = figures_.width(widestTime(caption));
  write(figures_, time, at + glm::vec2(column - figures_.width(time), 0), within, frame);
  at.x += column;
  write(figures_, " ms" + std::string(kGap) + medianText(caption), at, within, frame);
}

void CaptionPainter::write(Font& font, const std::string& text, const glm::vec2& at,
                           const PixelRange& within, Image& frame) {
  font.layOut(text, at, [&](char32_t, const Glyph& glyph, const glm::ivec2& place) {
    const glm::ivec2 low = glm::max(place, within.low);
    const glm::ivec2 high = glm::min(place + glyph.size, within.high);
    for (int y = low.y; y < high.y; ++y) {
      for (int x = low.x; x < high.x; ++x) {
        const std::size_t ink =
            static_cast<std::size_t>((y - place.y) * glyph.size.x + (x - place.x));
        std::uint8_t* pixel = &frame.rgba[4 * static_cast<std::size_t>(y * frame.width + x)];
        const float share = static_cast<float>(glyph.coverage[ink]) / 255;
        for (int c = 0; c < 3; ++c) pixel[c] = mix(pixel[c], 255, share);
      }
    }
  });
}

}  // namespace enfilade
