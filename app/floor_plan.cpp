#include "app/floor_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/plan_slice.h"
#include "app/portal_size.h"

namespace enfilade {

namespace {

constexpr float kScale = 40.0f;   // [pixels/m]
constexpr float kMargin = 40.0f;  // [pixels] about the page and between storeys
constexpr float kTitle = 34.0f;   // [pixels] above each storey
constexpr float kFoot = 56.0f;    // [pixels] below all
constexpr const char* kKindColor[] = {"#0a7d4f", "#d1570b", "#1467c8"};  // by PortalKind

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return out;
}

/// Neighbouring ids get colours far apart.
std::string cellColor(CellId cell) {
  const double hue = std::fmod(137.508 * cell, 360.0);
  return fmt::format("hsl({:.0f},{}%,{}%)", hue, 58 + 12 * (cell % 2), 80 - 5 * (cell % 3));
}

/// The part of the ground that all storeys are shown of [m].
struct Crop {
  glm::vec2 low{std::numeric_limits<float>::infinity()};
  glm::vec2 high{-std::numeric_limits<float>::infinity()};

  glm::vec2 pixels(float x, float z) const { return kScale * (glm::vec2(x, z) - low); }
  glm::vec2 size() const { return kScale * (high - low); }
};

/// About all that is not the exterior, a metre more, and never beyond the grid.
Crop cropOf(const House& house) {
  Crop crop;
  for (std::size_t c = 1; c < house.graph.cells.size(); ++c) {
    const Box& bounds = house.graph.cells[c].bounds;
    if (bounds.empty()) continue;
    crop.low = glm::min(crop.low, glm::vec2(bounds.min.x, bounds.min.z) - 1.0f);
    crop.high = glm::max(crop.high, glm::vec2(bounds.max.x, bounds.max.z) + 1.0f);
  }
  const CellGrid& grid = house.grid;
  const glm::vec2 low(grid.origin().x, grid.origin().z);
  const glm::vec2 high = low + grid.voxel() * glm::vec2(grid.size().x, grid.size().z);
  if (crop.low.x > crop.high.x) return {low, high};
  return {glm::max(crop.low, low), glm::min(crop.high, high)};
}

std::string outlinePath(const PlanSlice& slice, CellGrid::Label label, const Crop& crop) {
  std::string path;
  for (const auto& loop : traceOutline(slice, label)) {
    char command = 'M';
    for (const glm::ivec2& corner : loop) {
      const glm::vec2 p = crop.pixels(slice.origin.x + slice.voxel * static_cast<float>(corner.x),
                                      slice.origin.y + slice.voxel * static_cast<float>(corner.y));
      path += fmt::format("{}{:.1f} {:.1f}", command, p.x, p.y);
      command = 'L';
    }
    path += 'Z';
  }
  return path;
}

/// The cell's name without that of its storey, which stands above the plan.
std::string shortName(const CellGraph& graph, const Cell& cell) {
  const std::string before = graph.storeys[static_cast<std::size_t>(cell.storey)].name + " ";
  return cell.name.starts_with(before) ? cell.name.substr(before.size()) : cell.name;
}

std::string cellLabel(const PlanSlice& slice, const CellGraph& graph, CellId id, const Crop& crop) {
  const LabelPlace place = placeLabel(slice, static_cast<CellGrid::Label>(id));
  const float area = static_cast<float>(place.squares) * slice.voxel * slice.voxel;
  if (area < 0.5f) return {};
  const glm::vec2 p = crop.pixels(slice.origin.x + slice.voxel * place.center.x,
                                  slice.origin.y + slice.voxel * place.center.y);
  const float width = kScale * slice.voxel * place.width;
  const float height = kScale * slice.voxel * place.height;
  std::string name = shortName(graph, graph.cells[id]);
  const auto fit = [&] {
    return std::min(width / (0.6f * static_cast<float>(std::max<std::size_t>(name.size(), 4))),
                    height / 2.4f);
  };
  if (fit() < 6.0f) name = fmt::format("{}", id);
  const float font = std::clamp(fit(), 5.0f, 14.0f);
  std::string text =
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" text-anchor=\"middle\">{}",
                  p.x, p.y, font, escaped(name));
  if (height > 2.4f * font) {
    text += fmt::format("<tspan x=\"{:.1f}\" dy=\"1.15em\" class=\"area\">{:.1f} m²</tspan>", p.x,
                        area);
  }
  return text + "</text>\n";
}

/// Whether a portal is to be seen on the storey: its middle stands between this floor and the next.
bool standsOn(const CellGraph& graph, std::size_t storey, const Portal& portal) {
  const float y = portal.center().y;
  const auto& storeys = graph.storeys;
  const float below =
      storey == 0 ? -std::numeric_limits<float>::infinity() : storeys[storey].floor_y - 0.3f;
  const float above = storey + 1 < storeys.size() ? storeys[storey + 1].floor_y - 0.3f
                                                  : std::numeric_limits<float>::infinity();
  return y >= below && y < above;
}

std::string portalMark(const CellGraph& graph, const Portal& portal, PortalId id,
                       const Crop& crop) {
  const glm::vec2 size = portalSize(portal);
  const std::string title =
      fmt::format("<title>{} {}: {} to {}, {:.2f} x {:.2f} m</title>", kindName(portal.kind), id,
                  escaped(graph.cells[portal.front].name), escaped(graph.cells[portal.back].name),
                  size.x, size.y);
  const char* color = kKindColor[static_cast<std::size_t>(portal.kind)];
  std::string points;
  for (const glm::vec3& corner : portal.polygon) {
    const glm::vec2 p = crop.pixels(corner.x, corner.z);
    points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  }
  const char* style = isLevel(portal) ? "stroke-width=\"2\" stroke-dasharray=\"6 4\""
                                      : "stroke-width=\"5\" stroke-linejoin=\"round\"";
  return fmt::format("<polygon points=\"{}\" fill=\"none\" stroke=\"{}\" {}>{}</polygon>\n", points,
                     color, style, title);
}

std::string storeyPlan(const House& house, std::size_t storey, float slice_height,
                       const Crop& crop) {
  const CellGraph& graph = house.graph;
  const Storey& level = graph.storeys[storey];
  const PlanSlice slice = sliceHouse(graph, house.grid, level.floor_y + slice_height);
  const glm::vec2 size = crop.size();
  std::string svg = fmt::format("<text y=\"-12\" font-size=\"16\">{}, floor at {:.2f} m</text>\n",
                                escaped(level.name), level.floor_y);
  svg += fmt::format("<svg width=\"{:.1f}\" height=\"{:.1f}\">\n", size.x, size.y);
  std::string labels;
  for (CellId id = 1; id < graph.cells.size(); ++id) {
    const std::string path = outlinePath(slice, static_cast<CellGrid::Label>(id), crop);
    if (path.empty()) continue;
    svg += fmt::format("<path d=\"{}\" fill=\"{}\"><title>{} {}</title></path>\n", path,
                       cellColor(id), id, escaped(graph.cells[id].name));
    labels += cellLabel(slice, graph, id, crop);
  }
  svg += fmt::format("<path d=\"{}\" fill=\"#3a3f47\"/>\n",
                     outlinePath(slice, CellGrid::kSolidVoxel, crop));
  for (PortalId id = 0; id < graph.portals.size(); ++id) {
    if (standsOn(graph, storey, graph.portals[id])) {
      svg += portalMark(graph, graph.portals[id], id, crop);
    }
  }
  return svg + labels + "</svg>\n";
}

/// Scale bar and what the colours of the portals mean.
std::string foot(float y) {
  std::string svg = fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n", kMargin, y);
  for (int metre = 0; metre < 5; ++metre) {
    svg += fmt::format(
        "<rect x=\"{:.1f}\" width=\"{:.1f}\" height=\"6\" fill=\"{}\" stroke=\"#1b1f24\"/>\n",
        kScale * static_cast<float>(metre), kScale, metre % 2 == 0 ? "#1b1f24" : "#ffffff");
  }
  svg += fmt::format(
      "<text y=\"22\" font-size=\"12\">0</text><text x=\"{:.1f}\" y=\"22\" font-size=\"12\">5 "
      "m</text>\n",
      5 * kScale - 8);
  float x = 0;
  for (const PortalKind kind : {PortalKind::kOpening, PortalKind::kDoor, PortalKind::kWindow}) {
    svg += fmt::format(
        "<path d=\"M{:.0f} 36h22\" stroke=\"{}\" stroke-width=\"5\"/><text x=\"{:.0f}\" y=\"40\" "
        "font-size=\"12\">{}</text>\n",
        x, kKindColor[static_cast<std::size_t>(kind)], x + 28, kindName(kind));
    x += 100;
  }
  return svg + "</g>\n";
}

}  // namespace

std::string floorPlanSvg(const House& house, float slice_height) {
  const Crop crop = cropOf(house);
  const auto storeys = static_cast<float>(house.graph.storeys.size());
  const float step = crop.size().x + kMargin;
  const float width = std::max(kMargin + storeys * step, 360.0f);
  const float height = kMargin + kTitle + crop.size().y + kMargin + kFoot;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, sans-serif\" fill=\"#1b1f24\">\n"
      "<style>.area{{fill:#4a525c;font-size:.8em}}</style>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n",
      width, height);
  for (std::size_t storey = 0; storey < house.graph.storeys.size(); ++storey) {
    svg += fmt::format("<g transform=\"translate({:.1f} {:.1f})\" fill-rule=\"evenodd\">\n{}</g>\n",
                       kMargin + static_cast<float>(storey) * step, kMargin + kTitle,
                       storeyPlan(house, storey, slice_height, crop));
  }
  return svg + foot(height - kFoot) + "</svg>\n";
}

}  // namespace enfilade
