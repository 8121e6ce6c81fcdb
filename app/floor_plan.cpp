#include "app/floor_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade {

namespace {

constexpr float kScale = 40.0f;     // [pixels/m], of a house; less where the page would be
constexpr float kWidest = 3000.0f;  // [pixels] than this
constexpr float kMargin = 40.0f;    // [pixels] about the page and between storeys
constexpr float kTitle = 34.0f;     // [pixels] above each storey
constexpr float kFoot = 56.0f;      // [pixels] below all

/// Neighbouring ids get colours far apart.
std::string cellColor(CellId cell) {
  const double hue = std::fmod(137.508 * cell, 360.0);
  return fmt::format("hsl({:.0f},{}%,{}%)", hue, 58 + 12 * (cell % 2), 80 - 5 * (cell % 3));
}

/// Whether what has its middle at height `y` is to be seen on the storey: between this floor and
/// the next.
bool standsOn(const CellGraph& graph, std::size_t storey, float y) {
  const auto& storeys = graph.storeys;
  const float below =
      storey == 0 ? -std::numeric_limits<float>::infinity() : storeys[storey].floor_y - 0.3f;
  const float above = storey + 1 < storeys.size() ? storeys[storey + 1].floor_y - 0.3f
                                                  : std::numeric_limits<float>::infinity();
  return y >= below && y < above;
}

/// A storey with its name above it.
std::string storeyPlan(const House& house, std::size_t storey, float slice_height,
                       const PlanCrop& crop) {
  const Storey& level = house.graph.storeys[storey];
  const glm::vec2 size = crop.size();
  return fmt::format(
      "<text y=\"-12\" font-size=\"16\">{}, floor at {:.2f} m</text>\n"
      "<svg width=\"{:.1f}\" height=\"{:.1f}\">\n{}</svg>\n",
      escapedXml(level.name), level.floor_y, size.x, size.y,
      storeyDrawing(house, storey, slice_height, crop));
}

}  // namespace

PlanCrop planCrop(const House& house) {
  PlanCrop crop;
  for (std::size_t c = 1; c < house.graph.cells.size(); ++c) {
    const Box& bounds = house.graph.cells[c].bounds;
    if (bounds.empty()) continue;
    crop.low = glm::min(crop.low, glm::vec2(bounds.min.x, bounds.min.z) - 1.0f);
    crop.high = glm::max(crop.high, glm::vec2(bounds.max.x, bounds.max.z) + 1.0f);
  }
  for (const Leak& leak : house.info.leaks) {
    for (const glm::vec3& p : leak.path) {
      crop.low = glm::min(crop.low, glm::vec2(p.x, p.z) - 1.0f);
      crop.high = glm::max(crop.high, glm::vec2(p.x, p.z) + 1.0f);
    }
  }
  const CellGrid& grid = house.grid;
  const glm::vec2 low(grid.origin().x, grid.origin().z);
  const glm::vec2 high = low + grid.voxel() * glm::vec2(grid.size().x, grid.size().z);
  const bool empty = crop.low.x > crop.high.x;
  crop.low = empty ? low : glm::max(crop.low, low);
  crop.high = empty ? high : glm::min(crop.high, high);
  return crop;
}

std::string storeyDrawing(const House& house, std::size_t storey, float slice_height,
                          const PlanCrop& crop) {
  const CellGraph& graph = house.graph;
  const Storey& level = graph.storeys[storey];
  const PlanSlice slice = sliceHouse(graph, house.grid, level.floor_y + slice_height);
  std::string svg;
  std::string labels;
  for (CellId id = 1; id < graph.cells.size(); ++id) {
    const std::string path = outlinePath(slice, static_cast<CellGrid::Label>(id), crop);
    if (path.empty()) continue;
    svg += fmt::format("<path class=\"cell\" d=\"{}\" fill=\"{}\"><title>{} {}</title></path>\n",
                       path, cellColor(id), id, escapedXml(graph.cells[id].name));
    labels += cellLabel(slice, graph, id, crop);
  }
  svg += fmt::format("<path class=\"wall\" d=\"{}\" fill=\"#3a3f47\"/>\n",
                     outlinePath(slice, CellGrid::kSolidVoxel, crop));
  for (PortalId id = 0; id < graph.portals.size(); ++id) {
    if (standsOn(graph, storey, graph.portals[id].center().y)) {
      svg += portalMark(graph, id, crop);
    }
  }
  svg += labels;
  for (const Leak& leak : house.info.leaks) {
    if (standsOn(graph, storey, leak.place.y)) svg += leakMark(leak, crop);
  }
  return svg;
}

std::string floorPlanSvg(const House& house, float slice_height) {
  const auto storeys = static_cast<float>(house.graph.storeys.size());
  PlanCrop crop = planCrop(house);
  crop.scale = std::min(kScale, kWidest / (storeys * (crop.high.x - crop.low.x)));
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
  return svg + fmt::format("<g transform=\"translate({:.1f} {:.1f})\">\n{}</g>\n</svg>\n", kMargin,
                           height - kFoot, planFoot(crop, !house.info.leaks.empty()));
}

}  // namespace enfilade
