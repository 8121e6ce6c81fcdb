#include "app/view/help_panel.h"

#include <algorithm>
#include <string>

namespace enfilade {

namespace {

/// A group of lines with its heading.
struct Group {
  std::string name;
  std::vector<const Binding*> lines;
};

std::vector<Group> groups() {
  std::vector<Group> found;
  for (const Binding& binding : bindings()) {
    if (found.empty() || found.back().name != binding.group) found.push_back({binding.group, {}});
    found.back().lines.push_back(&binding);
  }
  return found;
}

}  // namespace

void HelpPanel::draw(OverlayPainter& overlay, const Theme& theme,
                     const std::optional<glm::vec2>& pointer) {
  lines_.clear();
  const float line = overlay.lineHeight(theme.text()) + 1, pad = 2 * theme.padding();
  const float keys = 96 * theme.scale, column = 430 * theme.scale;
  const std::vector<Group> all = groups();
  // Two columns of about the same height where the window is wide enough.
  std::size_t rows = 0;
  for (const Group& group : all) rows += group.lines.size() + 2;
  const int columns = overlay.size().x > 2 * column + 2 * pad ? 2 : 1;
  std::vector<std::vector<const Group*>> split(1);
  std::size_t filled = 0;
  std::vector<std::size_t> heights(1, 0);
  for (const Group& group : all) {
    const std::size_t height = group.lines.size() + 2;
    if (columns == 2 && split.size() == 1 && filled + height / 2 > rows / 2) {
      split.emplace_back();
      heights.push_back(0);
    }
    split.back().push_back(&group);
    heights.back() += height;
    filled += height;
  }
  const auto tallest = static_cast<float>(*std::max_element(heights.begin(), heights.end()));
  const glm::vec2 size(2 * pad + column * static_cast<float>(split.size()),
                       2 * pad + line * (tallest - 1));
  const glm::vec2 low = glm::max(glm::floor(0.5f * (overlay.size() - size)), glm::vec2(0));
  overlay.box({low, low + size}, {0.07f, 0.08f, 0.10f, 0.93f});
  for (std::size_t c = 0; c < split.size(); ++c) {
    glm::vec2 at = low + glm::vec2(pad + column * static_cast<float>(c), pad);
    for (const Group* group : split[c]) {
      overlay.text(group->name, at, theme.bold(Theme::kAccent));
      at.y += line;
      for (const Binding* binding : group->lines) {
        const PixelBox box{at, at + glm::vec2(column - pad, line)};
        if (binding->command) {
          lines_.push_back({box, *binding->command});
          if (pointer && box.contains(*pointer)) overlay.box(box, Theme::kHover);
        }
        overlay.text(binding->keys, at, theme.text());
        overlay.text(binding->what, at + glm::vec2(keys, 0), theme.text(Theme::kFaint));
        at.y += line;
      }
      at.y += line;
    }
  }
}

std::optional<Command> HelpPanel::commandAt(const glm::vec2& pixel) const {
  for (const Line& line : lines_) {
    if (line.box.contains(pixel)) return line.command;
  }
  return std::nullopt;
}

}  // namespace enfilade
