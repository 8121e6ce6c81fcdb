#include "app/plan_marks.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/portal_color.h"
#include "app/portal_size.h"
#include "portals/house_names.h"

namespace enfilade {

namespace {

constexpr const char* kLeakColor = "#d01030";

/// The cell's name without that of its storey, which stands above the plan.
std::string shortName(const CellGraph& graph, const Cell& cell) {
  const std::string before = graph.storeys[static_cast<std::size_t>(cell.storey)].name + " ";
  return cell.name.starts_with(before) ? cell.name.substr(before.size()) : cell.name;
}

}  // namespace

std::string escapedXml(const std::string& text) {
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

std::string outlinePath(const PlanSlice& slice, CellGrid::Label label, const PlanCrop& crop) {
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

std::string cellLabel(const PlanSlice& slice, const CellGraph& graph, CellId id,
                      const PlanCrop& crop) {
  const LabelPlace place = placeLabel(slice, static_cast<CellGrid::Label>(id));
  const float area = static_cast<float>(place.squares) * slice.voxel * slice.voxel;
  if (area < 0.5f) return {};
  const glm::vec2 p = crop.pixels(slice.origin.x + slice.voxel * place.center.x,
                                  slice.origin.y + slice.voxel * place.center.y);
  const float width = crop.scale * slice.voxel * place.width;
  const float height = crop.scale * slice.voxel * place.height;
  std::string name = shortName(graph, graph.cells[id]);
  const auto fit = [&] {
    return std::min(width / (0.6f * static_cast<float>(std::max<std::size_t>(name.size(), 4))),
                    height / 2.4f);
  };
  if (fit() < 6.0f) name = fmt::format("{}", id);
  const float font = std::clamp(fit(), 5.0f, 14.0f);
  std::string text =
      fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.1f}\" text-anchor=\"middle\">{}",
                  p.x, p.y, font, escapedXml(name));
  if (height > 2.4f * font) {
    text += fmt::format("<tspan x=\"{:.1f}\" dy=\"1.15em\" class=\"area\">{:.1f} m²</tspan>", p.x,
                        area);
  }
  return text + "</text>\n";
}

std::string portalMark(const CellGraph& graph, PortalId id, const PlanCrop& crop) {
  const Portal& portal = graph.portals[id];
  const glm::vec2 size = portalSize(portal);
  const std::string title =
      fmt::format("<title>{} {}: {} to {}, {:.2f} x {:.2f} m</title>", kindName(portal.kind), id,
                  escapedXml(graph.cells[portal.front].name),
                  escapedXml(graph.cells[portal.back].name), size.x, size.y);
  std::string points;
  for (const glm::vec3& corner : portal.polygon) {
    const glm::vec2 p = crop.pixels(corner.x, corner.z);
    points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  }
  const char* style = isLevel(portal) ? "stroke-width=\"2\" stroke-dasharray=\"6 4\""
                                      : "stroke-width=\"5\" stroke-linejoin=\"round\"";
  return fmt::format("<polygon points=\"{}\" fill=\"none\" stroke=\"#{:06x}\" {}>{}</polygon>\n",
                     points, portalColor(portal.kind), style, title);
}

std::string leakMark(const Leak& leak, const PlanCrop& crop) {
  std::string points;
  for (const glm::vec3& corner : leak.path) {
    const glm::vec2 p = crop.pixels(corner.x, corner.z);
    points += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
  }
  const glm::vec2 start = crop.pixels(leak.path.front().x, leak.path.front().z);
  const glm::vec2 hole = crop.pixels(leak.place.x, leak.place.z);
  const std::string room = escapedXml(leak.room);
  return fmt::format(
      "<g fill=\"none\" stroke=\"{0}\"><title>{1} leaks into {2} at height {3:.2f} m</title>\n"
      "<polyline points=\"{4}\" stroke-width=\"2.5\" stroke-dasharray=\"7 4\" "
      "marker-end=\"url(#leak)\"/>\n"
      "<circle cx=\"{5:.1f}\" cy=\"{6:.1f}\" r=\"9\" stroke-width=\"2\"/>\n"
      "<text x=\"{7:.1f}\" y=\"{8:.1f}\" font-size=\"11\" text-anchor=\"middle\" stroke=\"none\" "
      "fill=\"{0}\">{1}</text></g>\n",
      kLeakColor, room, escapedXml(leak.into), leak.place.y, points, hole.x, hole.y, start.x,
      start.y - 6);
}

std::string planFoot(const PlanCrop& crop, bool leaks) {
  // The shortest round length that is easily seen.
  int metres = 5;
  for (const int longer : {10, 20, 50, 100, 200, 500, 1000}) {
    if (static_cast<float>(metres) * crop.scale < 120) metres = longer;
  }
  const float part = crop.scale * static_cast<float>(metres) / 5;
  std::string svg;
  for (int i = 0; i < 5; ++i) {
    svg += fmt::format(
        "<rect x=\"{:.1f}\" width=\"{:.1f}\" height=\"6\" fill=\"{}\" stroke=\"#1b1f24\"/>\n",
        part * static_cast<float>(i), part, i % 2 == 0 ? "#1b1f24" : "#ffffff");
  }
  svg += fmt::format(
      "<text y=\"22\" font-size=\"12\">0</text><text x=\"{:.1f}\" y=\"22\" font-size=\"12\">{} "
      "m</text>\n",
      5 * part - 8, metres);
  float x = 0;
  for (const PortalKind kind : {PortalKind::kOpening, PortalKind::kDoor, PortalKind::kWindow}) {
    svg += fmt::format(
        "<path d=\"M{:.0f} 36h22\" stroke=\"#{:06x}\" stroke-width=\"5\"/><text x=\"{:.0f}\" "
        "y=\"40\" "
        "font-size=\"12\">{}</text>\n",
        x, portalColor(kind), x + 28, kindName(kind));
    x += 100;
  }
  if (leaks) {
    svg += fmt::format(
        "<defs><marker id=\"leak\" viewBox=\"0 0 8 8\" refX=\"6\" refY=\"4\" markerWidth=\"5\" "
        "markerHeight=\"5\" orient=\"auto\"><path d=\"M0 0L8 4L0 8Z\" "
        "fill=\"{0}\"/></marker></defs>\n"
        "<path d=\"M{1:.0f} 36h22\" stroke=\"{0}\" stroke-width=\"2.5\" "
        "stroke-dasharray=\"7 4\"/><text x=\"{2:.0f}\" y=\"40\" font-size=\"12\">leak</text>\n",
        kLeakColor, x, x + 28);
  }
  return svg;
}

}  // namespace enfilade
