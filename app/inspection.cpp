#include "app/inspection.h"

#include <fmt/format.h>

#include <map>

namespace enfilade {

namespace {

bool isDegenerate(const std::vector<glm::vec3>& positions, const std::uint32_t* triangle) {
  const glm::dvec3 a = positions[triangle[0]], b = positions[triangle[1]],
                   c = positions[triangle[2]];
  return glm::cross(b - a, c - a) == glm::dvec3(0);
}

std::size_t degenerateTriangles(const Building& building) {
  std::size_t count = 0;
  for (const Mesh& mesh : building.meshes) {
    const auto& positions = building.vertex_arrays[mesh.vertices].positions;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      count += isDegenerate(positions, &mesh.indices[i]);
    }
  }
  return count;
}

/// "IfcDoor" of "IfcDoor/Name/Id"; empty for another name.
std::string ifcClass(const std::string& name) {
  if (!name.starts_with("Ifc")) return {};
  return name.substr(0, name.find_first_of("/ :"));
}

void countNodes(const Building& building, BuildingFacts& facts) {
  std::map<std::string, std::size_t> classes;
  for (const Node& node : building.nodes) {
    facts.rooms_named +=
        node.name.ends_with("-room") || node.extras.find("\"cell\"") != std::string::npos;
    facts.portals_named += node.name.find("-portal") != std::string::npos ||
                           node.extras.find("\"portal\"") != std::string::npos;
    const std::string ifc = ifcClass(node.name);
    if (!ifc.empty()) ++classes[ifc];
  }
  facts.classes.assign(classes.begin(), classes.end());
}

void noteSize(const BuildingFacts& facts, std::vector<std::string>& problems) {
  const glm::vec3 size = facts.bounds.size();
  const float longest = std::max(size.x, std::max(size.y, size.z));
  if (longest > 2000) {
    problems.push_back(fmt::format("{:.0f} m long: is the model in metres?", longest));
  } else if (longest < 2) {
    problems.push_back(fmt::format("only {:.2g} m long: is the model in metres?", longest));
  } else if (size.y > 2 * std::max(size.x, size.z)) {
    problems.push_back("more than twice as high as it is long: does +Y point up?");
  }
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
  facts.degenerate = degenerateTriangles(building);
  countNodes(building, facts);
  return facts;
}

std::vector<std::string> buildingProblems(const BuildingFacts& facts) {
  std::vector<std::string> problems;
  noteSize(facts, problems);
  if (facts.degenerate > 0) {
    problems.push_back(fmt::format("{} triangles without area", facts.degenerate));
  }
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
  return problems;
}

}  // namespace enfilade
