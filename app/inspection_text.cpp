#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "app/inspection.h"
#include "app/portal_size.h"
#include "portals/house_names.h"
#include "scene/printable.h"

namespace enfilade {

namespace {

/// 1234567 as "1,234,567".
std::string grouped(std::size_t number) {
  std::string text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), ",");
  }
  return text;
}

std::string list(const char* title, const std::vector<std::string>& lines) {
  std::string text = fmt::format("{}\n", title);
  for (const std::string& line : lines) text += "  " + printable(line) + "\n";
  return lines.empty() ? std::string() : text;
}

std::string buildingText(const BuildingFacts& f) {
  const glm::vec3 size = f.bounds.size();
  std::string text =
      fmt::format("  triangles  {} in {} objects\n", grouped(f.triangles), grouped(f.objects));
  text += fmt::format("  meshes     {}, {} of them closed\n", grouped(f.meshes),
                      grouped(f.closed_meshes));
  text += fmt::format("  materials  {}: {} masked, {} blended, {} double-sided\n", f.materials,
                      f.masked, f.blended, f.double_sided);
  text += fmt::format("  images     {}, {:.1f} megapixels\n", f.images,
                      static_cast<double>(f.image_pixels) / 1e6);
  text += fmt::format(
      "  size       {:.2f} x {:.2f} x {:.2f} m, from ({:.2f}, {:.2f}, {:.2f}) to ({:.2f}, {:.2f}, "
      "{:.2f})\n",
      size.x, size.y, size.z, f.bounds.min.x, f.bounds.min.y, f.bounds.min.z, f.bounds.max.x,
      f.bounds.max.y, f.bounds.max.z);
  return text;
}

std::string problemsText(const std::vector<std::string>& problems) {
  if (problems.empty()) return "nothing looks wrong\n";
  return list("what looks wrong", problems);
}

/// The commonest beginnings of the nodes' names, the most of them first.
std::string kindsText(const BuildingFacts& facts) {
  auto kinds = facts.kinds;
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  if (kinds.size() > 12) kinds.resize(12);
  std::string text;
  for (const auto& [name, count] : kinds) text += fmt::format(", {} {}", count, printable(name));
  return text.empty() ? text : "  nodes      " + text.substr(2) + "\n";
}

/// Patterns for the kinds of node that speak of `word`, joined by commas.
std::string patternsFor(const BuildingFacts& facts, const std::string& word) {
  std::string patterns;
  for (const auto& [name, count] : facts.kinds) {
    std::string lower = name;
    for (char& c : lower) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (lower.find(word) == std::string::npos || name.find('\'') != std::string::npos) continue;
    patterns += fmt::format("{}{}*", patterns.empty() ? "" : ",", printable(name));
  }
  return patterns;
}

/// What to say to `enfilade preprocess`, as far as the names tell.
std::string hint(const std::string& file, const BuildingFacts& facts) {
  std::string options;
  const std::string doors = patternsFor(facts, "door"), windows = patternsFor(facts, "window");
  if (!doors.empty()) options += " --doors '" + doors + "'";
  if (!windows.empty()) options += " --windows '" + windows + "'";
  return fmt::format("to find its cells and portals:\n  enfilade preprocess {} -o HOUSE{}\n", file,
                     options);
}

std::string cellTable(const CellGraph& graph) {
  std::string text = fmt::format("cells\n  {:>4} {:<28} {:<14} {:>8} {:>10}  {}\n", "id", "name",
                                 "storey", "area m2", "volume m3", "portals");
  for (std::size_t c = 0; c < graph.cells.size(); ++c) {
    const Cell& cell = graph.cells[c];
    const std::string storey =
        c == kExterior ? "" : graph.storeys[static_cast<std::size_t>(cell.storey)].name;
    const std::string area = c == kExterior ? "" : fmt::format("{:.1f}", cell.floor_area);
    const std::string volume = c == kExterior ? "" : fmt::format("{:.1f}", cell.volume);
    text += fmt::format("  {:>4} {:<28} {:<14} {:>8} {:>10}  {}\n", c, printable(cell.name),
                        printable(storey), area, volume, fmt::join(cell.portals, " "));
  }
  return text;
}

std::string portalTable(const CellGraph& graph) {
  std::vector<std::string> between;
  std::size_t widest = 7;
  for (const Portal& portal : graph.portals) {
    between.push_back(fmt::format("{} | {}{}{}", printable(graph.cells[portal.front].name),
                                  printable(graph.cells[portal.back].name),
                                  isLevel(portal) ? "  (level)" : "",
                                  portal.active ? "" : "  (shut)"));
    widest = std::max(widest, between.back().size());
  }
  std::string text = fmt::format("portals\n  {:>4} {:<8} {:>13} {:>8}  {:<{}}  {}\n", "id", "kind",
                                 "size m", "area m2", "between", widest, "name");
  for (std::size_t p = 0; p < graph.portals.size(); ++p) {
    const Portal& portal = graph.portals[p];
    const glm::vec2 size = portalSize(portal);
    text += fmt::format("  {:>4} {:<8} {:>13} {:>8.2f}  {:<{}}  {}\n", p, kindName(portal.kind),
                        fmt::format("{:.2f} x {:.2f}", size.x, size.y), portal.area(), between[p],
                        widest, printable(portal.name));
  }
  return text;
}

}  // namespace

std::string modelText(const std::string& file, const Building& building,
                      const std::vector<std::string>& warnings) {
  const BuildingFacts facts = describeBuilding(building);
  std::vector<std::string> problems = buildingProblems(facts);
  problems.insert(problems.begin(), warnings.begin(), warnings.end());
  std::string text =
      fmt::format("{}: a model{}\n", file,
                  building.copyright.empty() ? "" : ", " + printable(building.copyright));
  text += buildingText(facts);
  text +=
      fmt::format("  named      {} rooms, {} portals\n", facts.rooms_named, facts.portals_named);
  text += kindsText(facts);
  return text + problemsText(problems) + hint(file, facts);
}

std::string houseText(const std::string& folder, const House& house, const ImageCounts& images) {
  const CellGraph& graph = house.graph;
  std::string text =
      fmt::format("{}: a house, made from {} by enfilade {}\n", folder,
                  printable(house.info.model_name), printable(house.info.tool_version));
  text += buildingText(describeBuilding(house.building));
  text += fmt::format("  cells      {}, the exterior among them\n", graph.cells.size());
  text += fmt::format("  portals    {}, {} of their {} sides have images\n", graph.portals.size(),
                      images.sides, 2 * graph.portals.size());
  text += fmt::format("             {} textures, {} reference images, {} layered depth images\n",
                      images.textures, images.references, images.ldis);
  text += fmt::format("  distance   images beyond {:.2f} m, eye {:.2f} m above the floor\n",
                      house.switch_distance, house.eye_height);
  text += "storeys\n";
  for (std::size_t s = 0; s < graph.storeys.size(); ++s) {
    text += fmt::format("  {:>4} {:<28} floor at {:.2f} m\n", s, printable(graph.storeys[s].name),
                        graph.storeys[s].floor_y);
  }
  text += cellTable(graph) + portalTable(graph);
  std::vector<std::string> lines;
  for (const auto& [name, value] : house.info.parameters) lines.push_back(name + " = " + value);
  text += list("parameters", lines);
  lines.clear();
  for (const auto& [name, value] : house.info.statistics) {
    lines.push_back(fmt::format("{} = {:.6g}", name, value));
  }
  text += list("statistics", lines);
  text += list("what was decided", house.info.log);
  return text + problemsText(houseProblems(house));
}

}  // namespace enfilade
