#include "app/inspection.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/mesh_closure.h"
#include "portals/open_doors.h"
#include "scene/extent_doubts.h"

namespace enfilade {

namespace {

/// "IfcDoor" of "IfcDoor/Name/Id"; empty for a name without such a beginning.
std::string kindOf(const std::string& name) {
  const std::size_t end = name.find_first_of("/:");
  return end == std::string::npos ? std::string() : name.substr(0, end);
}

void countNodes(const Building& building, BuildingFacts& facts) {
  std::map<std::string, std::size_t> kinds;
  for (const Node& node : building.nodes) {
    facts.rooms_named +=
        node.name.ends_with("-room") || node.extras.find("\"cell\"") != std::string::npos;
    facts.portals_named += node.name.find("-portal") != std::string::npos ||
                           node.extras.find("\"portal\"") != std::string::npos;
    const std::string kind = kindOf(node.name);
    if (!kind.empty()) ++kinds[kind];
  }
  facts.kinds.assign(kinds.begin(), kinds.end());
}

}  // namespace

BuildingFacts describeBuilding(const Building& building) {
  BuildingFacts facts;
  facts.triangles = triangleCount(building);
  facts.objects = building.objects.size();
  facts.meshes = building.meshes.size();
  facts.nodes = building.nodes.size();
  facts.materials = building.materials.size();
  for (const Material& material : building.materials) {
    facts.masked += material.alpha_mode == AlphaMode::kMask;
    facts.blended += material.alpha_mode == AlphaMode::kBlend;
    facts.double_sided += material.double_sided;
  }
  facts.images = building.images.size();
  for (const TextureImage& image : building.images)
    facts.image_pixels += image.image.rgba.size() / 4;
  facts.bounds = worldBounds(building);
  for (const Mesh& mesh : building.meshes) facts.closed_meshes += isClosed(building, mesh);
  countNodes(building, facts);
  return facts;
}

std::vector<std::string> buildingProblems(const BuildingFacts& facts) {
  std::vector<std::string> problems = extentDoubts(facts.bounds);
  if (facts.rooms_named == 0 && facts.portals_named > 0) {
    problems.push_back(fmt::format("{} portals are named but no room", facts.portals_named));
  }
  return problems;
}

std::vector<std::string> houseProblems(const House& house) {
  std::vector<std::string> problems = diagnose(house.graph);
  const auto& cells = house.graph.cells;
  std::vector<std::size_t> objects_of(cells.size());
  for (const std::vector<CellId>& seen_from : house.object_cells) {
    for (const CellId cell : seen_from) ++objects_of[cell];
  }
  if (cells.size() == 1) problems.push_back(kNoRoom);
  for (std::size_t c = 1; c < cells.size(); ++c) {
    if (cells[c].volume <= 0) {
      problems.push_back(fmt::format("cell {} ({}) has no volume", c, cells[c].name));
    }
    if (objects_of[c] == 0) {
      problems.push_back(fmt::format("cell {} ({}) sees no object", c, cells[c].name));
    }
  }
  for (std::size_t p = 0; p < house.graph.portals.size(); ++p) {
    if (!house.graph.portals[p].active) problems.push_back(fmt::format("portal {} is shut", p));
  }
  for (const PortalId p : shutWithoutDoor(house)) {
    problems.push_back(fmt::format("no door stands in portal {}: {}", p, kShutWithoutDoor));
  }
  return problems;
}

}  // namespace enfilade
