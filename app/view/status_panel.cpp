#include "app/view/status_panel.h"

#include <fmt/format.h>

#include <algorithm>

namespace enfilade {

namespace {

constexpr float kGraphHeight = 72;  // [pixels of an ordinary screen]

/// "12,345"
std::string grouped(std::size_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string contents(const FrameCost& cost) {
  std::string line;
  const auto add = [&](const std::optional<std::size_t>& count, const char* what) {
    if (count) line += fmt::format("{}{} {}", line.empty() ? "" : " · ", grouped(*count), what);
  };
  add(cost.triangles, "triangles");
  add(cost.cells, "cells");
  return line.empty() ? "rays" : line;
}

std::string portalsOf(const FrameCost& cost) {
  if (!cost.portals) return {};
  std::string line = fmt::format("{} portals", *cost.portals);
  if (cost.portals_as_images) line += fmt::format(", {} as images", *cost.portals_as_images);
  if (cost.portals_lacking_image.value_or(0) > 0) {
    line += fmt::format(", {} not loaded", *cost.portals_lacking_image);
  }
  if (cost.samples) line += fmt::format(" · {} samples", grouped(*cost.samples));
  return line;
}

/// The time that fills the graph's height: a round one that holds most frames [ms].
double fullScale(const FrameHistory& history) {
  double most = 0;
  for (const FrameCost& cost : history.costs()) most = std::max(most, cost.frametime_ms);
  for (const double scale : {10.0, 20.0, 40.0, 80.0, 160.0, 320.0, 640.0}) {
    if (most <= scale) return scale;
  }
  return 1280;
}

void drawGraph(OverlayPainter& overlay, const Theme& theme, const PixelBox& box,
               const FrameHistory& history) {
  const double full = fullScale(history);
  const float bar = box.size().x / static_cast<float>(FrameHistory::kLength);
  const auto heightOf = [&](double ms) {
    return box.size().y * static_cast<float>(std::min(ms / full, 1.0));
  };
  overlay.box(box, {1, 1, 1, 0.06f});
  const std::span<const FrameCost> costs = history.costs();
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const float x = box.high.x - bar * static_cast<float>(costs.size() - i);
    double below = 0;
    const auto stages = stagesOf(costs[i]);
    for (std::size_t s = 0; s < kFrameStages; ++s) {
      const auto& c = frameStages()[s].color;
      overlay.box(
          {{x, box.high.y - heightOf(below + stages[s])}, {x + bar, box.high.y - heightOf(below)}},
          {c[0], c[1], c[2], 1});
      below += stages[s];
    }
  }
  for (const double guide : {1000.0 / 60, 1000.0 / 30}) {
    if (guide > full) continue;
    const float y = box.high.y - heightOf(guide);
    overlay.line({box.low.x, y}, {box.high.x, y}, theme.scale, {1, 1, 1, 0.35f});
    if (heightOf(1000.0 / 60) < 12 * theme.scale) continue;  // no room for their names
    overlay.text(fmt::format("{:.0f} a second", 1000 / guide), {box.low.x + 3 * theme.scale, y},
                 {10 * theme.scale, FontFace::kRegular, {1, 1, 1, 0.6f}});
  }
}

/// Names of the stages that the last frame had, each in its colour, with their times.  They stand
/// on two lines at most.
void drawStages(OverlayPainter& overlay, const Theme& theme, const glm::vec2& at, float width,
                const FrameCost& cost) {
  const auto stages = stagesOf(cost);
  float x = at.x, y = at.y;
  for (std::size_t s = 0; s + 1 < kFrameStages; ++s) {
    if (stages[s] < 0.005) continue;
    const auto& c = frameStages()[s].color;
    const std::string text = fmt::format("{} {:.1f}", frameStages()[s].name, stages[s]);
    const TextStyle style = theme.small({c[0], c[1], c[2], 1});
    const float wide = overlay.textWidth(text, style);
    if (x > at.x && x + wide > at.x + width) {
      x = at.x;
      y += overlay.lineHeight(style);
    }
    overlay.text(text, {x, y}, style);
    x += wide + 12 * theme.scale;
  }
}

}  // namespace

PixelBox drawStatus(OverlayPainter& overlay, const Theme& theme, const glm::vec2& corner,
                    bool to_the_left, const Status& status, const FrameHistory& history) {
  const float pad = theme.padding();
  const float width = std::min(330 * theme.scale, overlay.size().x - 2 * theme.margin());
  const float line = overlay.lineHeight(theme.text()), small = overlay.lineHeight(theme.small());
  const FrameCost cost = history.empty() ? FrameCost{} : history.last();
  const std::string portals = portalsOf(cost);
  float height = 2 * pad + 2 * line + small * (portals.empty() ? 1 : 2);
  if (!status.notes.empty()) height += small;
  const bool makes_images = cost.capture_ms || cost.load_ms;  // one stage more
  if (status.graph) height += (kGraphHeight + 8) * theme.scale + (makes_images ? 2 : 1) * small;
  PixelBox box{corner, corner + glm::vec2(width, height)};
  if (to_the_left) box = {{corner.x - width, corner.y}, {corner.x, corner.y + height}};
  overlay.box(box, Theme::kPanel);

  const double ms = history.medianMs(15);
  glm::vec2 at = box.low + glm::vec2(pad);
  overlay.text(infoOf(status.method).name, at, theme.bold(Theme::kAccent));
  const std::string time = fmt::format("{:.1f} ms", ms);
  overlay.text(time, {box.high.x - pad - overlay.textWidth(time, theme.bold()), at.y},
               theme.bold());
  const auto next = [&](const std::string& text, const TextStyle& style) {
    if (text.empty()) return;
    overlay.text(text, at, style);
    at.y += overlay.lineHeight(style);
  };
  at.y += line;
  next(status.place, theme.text());
  next(contents(cost), theme.small());
  next(portals, theme.small());
  next(status.notes, theme.small(Theme::kAccent));
  if (!status.graph) return box;
  at.y += 6 * theme.scale;
  const glm::vec2 low = at;
  drawGraph(overlay, theme, {low, {box.high.x - pad, low.y + kGraphHeight * theme.scale}}, history);
  drawStages(overlay, theme, {low.x, low.y + (kGraphHeight + 2) * theme.scale}, width - 2 * pad,
             cost);
  return box;
}

}  // namespace enfilade
