#include "app/view/plan_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/floor_plan.h"

namespace enfilade {

namespace {

constexpr float kSide = 270;          // [pixels of an ordinary screen] of the longer side
constexpr float kAround = 1.0f;       // [m] that the plan shows around what that of inspect does
constexpr float kSliceHeight = 1.2f;  // [m] above a floor
constexpr int kSlot = 10;             // of the overlay's pictures

struct Rgb {
  std::uint8_t r, g, b;
};

/// Neighbouring ids get colours far apart; cells that are seen are bright.
Rgb cellColor(CellId cell, bool seen) {
  if (cell == kExterior) return seen ? Rgb{74, 92, 74} : Rgb{40, 46, 44};
  const float hue = std::fmod(137.508f * static_cast<float>(cell), 360.0f) / 60.0f;
  const float value = seen ? 0.92f : 0.42f, chroma = value * (seen ? 0.34f : 0.25f);
  const auto channel = [&](float n) {
    const float k = std::fmod(n + hue, 6.0f);
    const float share = std::clamp(std::min(k, 4.0f - k), 0.0f, 1.0f);
    return static_cast<std::uint8_t>(255.0f * (value - chroma * share));
  };
  return {channel(5), channel(3), channel(1)};
}

}  // namespace

PlanPanel::PlanPanel(const House& house) : house_(house) {
  const PlanCrop crop = planCrop(house);
  low_ = crop.low - kAround;
  high_ = crop.high + kAround;
  pages_.resize(house.graph.storeys.size());
}

std::size_t PlanPanel::storeyOf(float y) const {
  const auto& storeys = house_.graph.storeys;
  std::size_t storey = 0;
  while (storey + 1 < storeys.size() && y >= storeys[storey + 1].floor_y) ++storey;
  return storey;
}

bool PlanPanel::standsOn(std::size_t storey, float y) const {
  return storeyOf(y + 0.3f) == storey;  // sills and thresholds reach below their floor
}

void PlanPanel::turnPage() { turned_ = (turned_ + 1) % pages_.size(); }

void PlanPanel::paint(Page& page, const glm::ivec2& size) const {
  page.size = size;
  page.picture.width = size.x;
  page.picture.height = size.y;
  page.picture.rgba.clear();
  const glm::vec2 step = (high_ - low_) / glm::vec2(size);
  for (int y = 0; y < size.y; ++y) {
    for (int x = 0; x < size.x; ++x) {
      const glm::vec2 p = low_ + step * (glm::vec2(x, y) + 0.5f);
      const glm::ivec2 square(glm::floor((p - page.slice.origin) / page.slice.voxel));
      CellGrid::Label label = kExterior;
      if (square.x >= 0 && square.y >= 0 && square.x < page.slice.columns &&
          square.y < page.slice.rows) {
        label = page.slice.at(square.x, square.y);
      }
      Rgb color{18, 20, 24};
      if (label < page.seen.size()) color = cellColor(label, page.seen[label] != 0);
      page.picture.rgba.insert(page.picture.rgba.end(), {color.r, color.g, color.b, 255});
    }
  }
}

const PlanPanel::Page& PlanPanel::page(std::size_t storey, const glm::ivec2& size,
                                       const VisibleSet* seen) {
  Page& page = pages_[storey];
  if (page.slice.owner.empty()) {
    page.slice =
        sliceHouse(house_.graph, house_.grid, house_.graph.storeys[storey].floor_y + kSliceHeight);
  }
  std::vector<std::uint8_t> cells(house_.graph.cells.size(), 0);
  if (seen != nullptr) {
    for (const VisibleCell& cell : seen->cells) cells[cell.cell] = 1;
  }
  const bool stale = page.size != size || page.seen != cells;
  if (stale) {
    page.seen = std::move(cells);
    paint(page, size);
  }
  changed_ = stale || storey != storey_;
  storey_ = storey;
  return page;
}

glm::vec2 PlanPanel::toPanel(const glm::vec3& p) const {
  return map_.low + (glm::vec2(p.x, p.z) - low_) / (high_ - low_) * map_.size();
}

std::optional<glm::vec3> PlanPanel::placeAt(const glm::vec2& pixel) const {
  if (!map_.contains(pixel)) return std::nullopt;
  const glm::vec2 p = low_ + (pixel - map_.low) / map_.size() * (high_ - low_);
  return glm::vec3(p.x, house_.graph.storeys[storey_].floor_y + house_.eye_height, p.y);
}

void PlanPanel::drawPortals(OverlayPainter& overlay, const Theme& theme,
                            const VisibleSet* seen) const {
  for (PortalId id = 0; id < house_.graph.portals.size(); ++id) {
    const Portal& portal = house_.graph.portals[id];
    if (!standsOn(storey_, portal.center().y)) continue;
    OverlayColor color = portal.active ? Theme::kUnseen : Theme::kShut;
    if (seen != nullptr) {
      for (const VisiblePortal& v : seen->portals) {
        if (v.portal == id) color = v.as_image ? Theme::kAsImage : Theme::kAsGeometry;
      }
    }
    // The longest side as seen from above: of an upright portal its width.
    glm::vec2 from(0), to(0);
    for (std::size_t i = 0; i < portal.polygon.size(); ++i) {
      const glm::vec2 a = toPanel(portal.polygon[i]);
      const glm::vec2 b = toPanel(portal.polygon[(i + 1) % portal.polygon.size()]);
      if (glm::length(b - a) > glm::length(to - from)) from = a, to = b;
    }
    overlay.line(from, to, 3 * theme.scale, color);
  }
}

void PlanPanel::drawCamera(OverlayPainter& overlay, const Theme& theme, const Camera& camera,
                           const OverlayColor& color) const {
  const glm::vec2 at = toPanel(camera.pose.position);
  if (!panel_.contains(at)) return;
  const glm::mat3 axes(camera.worldFromCamera());
  const float across = std::tan(0.5f * camera.vertical_fov) * camera.aspect;
  const auto towards = [&](float side) {
    const glm::vec3 ray = axes * glm::vec3(side * across, 0, -1);
    const glm::vec2 flat(ray.x, ray.z);
    const float length = glm::length(flat);
    const glm::vec2 end = at + (length > 0 ? flat / length : glm::vec2(0)) * 34.0f * theme.scale;
    return glm::clamp(end, panel_.low, panel_.high);
  };
  overlay.triangle({at, towards(-1), towards(1)}, {color.r, color.g, color.b, 0.35f});
  const float r = 4 * theme.scale;
  overlay.box({at - r - theme.scale, at + r + theme.scale}, {0, 0, 0, 1});
  overlay.box({at - r, at + r}, color);
}

void PlanPanel::draw(OverlayPainter& overlay, const Theme& theme, const glm::vec2& corner,
                     const PlanMarks& marks) {
  const std::size_t own = storeyOf(marks.camera.pose.position.y);
  if (own != eye_storey_) turned_ = 0;
  eye_storey_ = own;
  const std::size_t storey = (own + turned_) % pages_.size();

  const glm::vec2 extent = high_ - low_, window = overlay.size();
  const float side = std::min(kSide * theme.scale, 0.4f * std::min(window.x, window.y));
  const glm::vec2 size =
      glm::max(glm::round(extent * (side / std::max(extent.x, extent.y))), glm::vec2(1));
  const float line = overlay.lineHeight(theme.small()), pad = theme.padding();
  panel_ = {corner - size - glm::vec2(2 * pad, 2 * pad + line), corner};
  map_ = {panel_.low + glm::vec2(pad, pad + line), corner - glm::vec2(pad)};
  const Page& page = this->page(storey, glm::ivec2(size), marks.seen);

  overlay.box(panel_, Theme::kPanel);
  overlay.picture(map_, page.picture, kSlot, changed_, false);
  drawPortals(overlay, theme, marks.seen);
  if (marks.path != nullptr) {
    for (std::size_t i = 1; i < marks.path->size(); ++i) {
      overlay.line(toPanel((*marks.path)[i - 1]), toPanel((*marks.path)[i]), 1.5f * theme.scale,
                   Theme::kAccent);
    }
  }
  if (marks.frozen) drawCamera(overlay, theme, *marks.frozen, {0.45f, 0.75f, 1, 1});
  if (storey == own) drawCamera(overlay, theme, marks.camera, {1, 1, 1, 1});

  std::string title = house_.graph.storeys[storey].name;
  if (marks.pointer) {
    if (const auto place = placeAt(*marks.pointer)) {
      const CellLocation where = locate(house_.graph, house_.grid, *place);
      if (where.in_free_space) title = house_.graph.cells[where.cell].name;
    }
  }
  overlay.text(title, panel_.low + glm::vec2(pad, 0.5f * pad), theme.small(Theme::kInk));
}

}  // namespace enfilade
