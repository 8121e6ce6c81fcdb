#pragma once

#include <optional>
#include <vector>

#include "app/view/actions.h"
#include "app/view/theme.h"

namespace enfilade {

/// The list of keys over the middle of the window.  Its lines can be clicked.
class HelpPanel {
 public:
  void draw(OverlayPainter& overlay, const Theme& theme, const std::optional<glm::vec2>& pointer);

  /// What the line at `pixel`, as drawn last, does.
  std::optional<Command> commandAt(const glm::vec2& pixel) const;

 private:
  struct Line {
    PixelBox box;
    Command command;
  };
  std::vector<Line> lines_;
};

}  // namespace enfilade
