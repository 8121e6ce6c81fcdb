#pragma once

#include <string>

#include "app/stopwatch.h"
#include "app/view/theme.h"

namespace enfilade {

/// A line that tells what happened, for some seconds.
class Toast {
 public:
  void say(const std::string& text) {
    text_ = text;
    since_ = Stopwatch();
  }
  void dismiss() { text_.clear(); }
  bool shows() const { return !text_.empty() && since_.totalMs() < 4000; }

  void draw(OverlayPainter& overlay, const Theme& theme) const {
    if (!shows()) return;
    const TextStyle style = theme.text();
    const glm::vec2 half(0.5f * overlay.textWidth(text_, style), 0.5f * overlay.lineHeight(style));
    const glm::vec2 at(0.5f * overlay.size().x, overlay.size().y - 48 * theme.scale);
    const glm::vec2 room(theme.padding(), 0.6f * theme.padding());
    overlay.box({at - half - room, at + half + room}, Theme::kPanel);
    overlay.text(text_, at - half, style);
  }

 private:
  std::string text_;
  Stopwatch since_;
};

}  // namespace enfilade
