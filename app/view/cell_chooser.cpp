#include "app/view/cell_chooser.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace enfilade {

namespace {

constexpr std::size_t kRows = 16;  // on screen at once

std::string lowered(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Takes the last character of UTF-8 text away.
void dropLast(std::string& text) {
  while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xc0) == 0x80) text.pop_back();
  if (!text.empty()) text.pop_back();
}

void append(std::string& text, char32_t c) {
  const auto byte = [&](unsigned bits) { text += static_cast<char>(bits); };
  if (c < 0x80) {
    byte(c);
  } else if (c < 0x800) {
    byte(0xc0 | (c >> 6)), byte(0x80 | (c & 63));
  } else if (c < 0x10000) {
    byte(0xe0 | (c >> 12)), byte(0x80 | ((c >> 6) & 63)), byte(0x80 | (c & 63));
  } else {
    byte(0xf0 | (c >> 18)), byte(0x80 | ((c >> 12) & 63)), byte(0x80 | ((c >> 6) & 63)),
        byte(0x80 | (c & 63));
  }
}

}  // namespace

void CellChooser::open() {
  open_ = true;
  opened_by_key_ = true;
  typed_.clear();
  filter();
}

void CellChooser::filter() {
  offered_.clear();
  chosen_ = first_ = 0;
  const std::string part = lowered(typed_);
  for (CellId id = 0; id < graph_.cells.size(); ++id) {
    if (lowered(graph_.cells[id].name).find(part) != std::string::npos) offered_.push_back(id);
  }
}

std::optional<CellId> CellChooser::choose(std::size_t index) {
  if (index >= offered_.size()) return std::nullopt;
  open_ = false;
  return offered_[index];
}

std::optional<CellId> CellChooser::take(const WindowEvent& event) {
  using Kind = WindowEvent::Kind;
  if (event.kind == Kind::kText) {
    if (std::exchange(opened_by_key_, false)) return std::nullopt;
    append(typed_, event.character);
    filter();
  } else if (event.kind == Kind::kMouseDown) {
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      if (rows_[row].contains(event.at)) return choose(first_ + row);
    }
    close();
  } else if (event.kind == Kind::kKeyDown || event.kind == Kind::kKeyRepeat) {
    opened_by_key_ = false;
    const std::size_t last = offered_.empty() ? 0 : offered_.size() - 1;
    if (event.key == key::kEnter) return choose(chosen_);
    if (event.key == key::kEscape) close();
    if (event.key == key::kBackspace) dropLast(typed_), filter();
    if (event.key == key::kDown) chosen_ = std::min(chosen_ + 1, last);
    if (event.key == key::kUp && chosen_ > 0) --chosen_;
    if (event.key == key::kPageDown) chosen_ = std::min(chosen_ + kRows, last);
    if (event.key == key::kPageUp) chosen_ -= std::min(chosen_, kRows);
  }
  first_ = std::clamp(first_, chosen_ + 1 - std::min(chosen_ + 1, kRows), chosen_);
  return std::nullopt;
}

void CellChooser::draw(OverlayPainter& overlay, const Theme& theme,
                       const std::optional<glm::vec2>& pointer) {
  rows_.clear();
  const float line = overlay.lineHeight(theme.text()) + 2, pad = 2 * theme.padding();
  const std::size_t shown = std::min(offered_.size() - first_, kRows);
  const glm::vec2 size(420 * theme.scale, 2 * pad + line * (1.5f + static_cast<float>(kRows)));
  const glm::vec2 low = glm::max(glm::floor(0.5f * (overlay.size() - size)), glm::vec2(0));
  overlay.box({low, low + size}, {0.07f, 0.08f, 0.10f, 0.93f});
  glm::vec2 at = low + pad;
  overlay.text("Go to: " + typed_ + "▏", at, theme.bold(Theme::kAccent));
  at.y += 1.5f * line;
  if (offered_.empty()) overlay.text("no cell is called so", at, theme.text(Theme::kFaint));
  for (std::size_t row = 0; row < shown; ++row) {
    const Cell& cell = graph_.cells[offered_[first_ + row]];
    const PixelBox box{at, at + glm::vec2(size.x - 2 * pad, line)};
    rows_.push_back(box);
    if (first_ + row == chosen_) overlay.box(box, {0.98f, 0.72f, 0.25f, 0.25f});
    if (pointer && box.contains(*pointer)) overlay.box(box, Theme::kHover);
    overlay.text(cell.name, at + glm::vec2(4 * theme.scale, 0), theme.text());
    std::string facts = graph_.storeys[static_cast<std::size_t>(cell.storey)].name;
    if (cell.floor_area > 0) facts += fmt::format(", {:.1f} m²", cell.floor_area);
    overlay.text(facts, {box.high.x - overlay.textWidth(facts, theme.small()), at.y + 1},
                 theme.small());
    at.y += line;
  }
}

}  // namespace enfilade
