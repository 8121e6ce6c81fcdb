#include <fmt/format.h>

#include "app/inspection.h"
#include "app/portal_size.h"

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
  for (const std::string& line : lines) text += "  " + line + "\n";
  return lines.empty() ? std::string() : text;
}

std::string buildingText(const BuildingFacts& f) {
  const glm::vec3 size = f.bounds.size();
  std::string text = fmt::format("  triangles  {} in {} objects of {} meshes\n",
                                 grouped(f.triangles), grouped(f.objects), grouped(f.meshes));
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

/// What to say to `enfilade preprocess`, as far as the names tell.
std::string hint(const std::string& file, const BuildingFacts& facts) {
  std::string options;
  for (const auto& [name, count] : facts.classes) {
    if (name == "IfcDoor") options += " --doors 'IfcDoor*'";
    if (name == "IfcWindow") options += " --windows 'IfcWindow*'";
  }
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
    text += fmt::format("  {:>4} {:<28} {:<14} {:>8} {:>10}  {}\n", c, cell.name, storey, area,
                        volume, fmt::join(cell.portals, " "));
  }
  return text;
}

std::string portalTable(const CellGraph& graph) {
  std::string text = fmt::format("portals\n  {:>4} {:<8} {:>13} {:>8}  {}\n", "id", "kind",
                                 "size m", "area m2", "between");
  for (std::size_t p = 0; p < graph.portals.size(); ++p) {
    const Portal& portal = graph.portals[p];
    const glm::vec2 size = portalSize(portal);
    text += fmt::format("  {:>4} {:<8} {:>13} {:>8.2f}  {} | {}{}\n", p, kindName(portal.kind),
                        fmt::format("{:.2f} x {:.2f}", size.x, size.y), portal.area(),
                        graph.cells[portal.front].name, graph.cells[portal.back].name,
                        isLevel(portal) ? "  (level)" : "");
  }
  return text;
}

}  // namespace

std::string modelText(const std::string& file, const Building& building,
                      const std::vector<std::string>& warnings) {
  const BuildingFacts facts = describeBuilding(building);
  std::vector<std::string> problems = buildingProblems(facts);
  problems.insert(problems.begin(), warnings.begin(), warnings.end());
  std::string text = fmt::format("{}: a model{}\n", file,
                                 building.copyright.empty() ? "" : ", " + building.copyright);
  text += buildingText(facts);
  text +=
      fmt::format("  named      {} rooms, {} portals\n", facts.rooms_named, facts.portals_named);
  std::string classes;
  for (const auto& [name, count] : facts.classes) classes += fmt::format(" {} {},", count, name);
  if (!classes.empty()) text += "  IFC       " + classes.substr(0, classes.size() - 1) + "\n";
  return text + problemsText(problems) + hint(file, facts);
}

std::string houseText(const std::string& folder, const House& house, std::size_t image_sides) {
  const CellGraph& graph = house.graph;
  std::string text = fmt::format("{}: a house, made from {} by enfilade {}\n", folder,
                                 house.info.model_name, house.info.tool_version);
  text += buildingText(describeBuilding(house.building));
  text += fmt::format("  cells      {}, the exterior among them\n", graph.cells.size());
  text += fmt::format("  portals    {}, {} of their {} sides have an image\n", graph.portals.size(),
                      image_sides, 2 * graph.portals.size());
  text += fmt::format("  distance   images beyond {:.2f} m, eye {:.2f} m above the floor\n",
                      house.switch_distance, house.eye_height);
  text += "storeys\n";
  for (std::size_t s = 0; s < graph.storeys.size(); ++s) {
    text += fmt::format("  {:>4} {:<28} floor at {:.2f} m\n", s, graph.storeys[s].name,
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
