#include "scene/building.h"

#include <fnmatch.h>

#include <sstream>

namespace enfilade {

Box worldBounds(const Building& building, const Object& object) {
  const Mesh& mesh = building.meshOf(object);
  const VertexArrays& vertices = building.vertex_arrays[mesh.vertices];
  const glm::mat4& world_from_object = building.worldFromObject(object);
  Box box;
  for (const std::uint32_t i : mesh.indices) {
    box.extend(glm::vec3(world_from_object * glm::vec4(vertices.positions[i], 1.0f)));
  }
  return box;
}

Box worldBounds(const Building& building) {
  Box box;
  for (const Object& object : building.objects) box.extend(worldBounds(building, object));
  return box;
}

std::size_t triangleCount(const Building& building) {
  std::size_t count = 0;
  for (const Object& object : building.objects) count += building.meshOf(object).indices.size() / 3;
  return count;
}

namespace {

/// Sets the flags of what `pattern` matches.
void matchOne(const Building& building, const std::string& pattern,
              std::vector<std::uint8_t>& flags) {
  const auto matches = [&](const std::string& name) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  };
  std::vector<std::uint8_t> nodes, materials;  // parents come before their children
  for (const Node& node : building.nodes) {
    nodes.push_back((node.parent != kNone && nodes[node.parent] != 0) || matches(node.name));
  }
  for (const Material& material : building.materials) materials.push_back(matches(material.name));
  for (std::size_t o = 0; o < flags.size(); ++o) {
    const Object& object = building.objects[o];
    const std::uint32_t material = building.meshOf(object).material;
    if (object.node != kNone && nodes[object.node] != 0) flags[o] = 1;
    if (materials[material] != 0) flags[o] = 1;
  }
}

}  // namespace

std::vector<std::uint8_t> matchNames(const Building& building, const std::string& patterns) {
  std::vector<std::uint8_t> flags(building.objects.size(), 0);
  std::istringstream stream(patterns);
  for (std::string pattern; std::getline(stream, pattern, ',');) {
    if (!pattern.empty()) matchOne(building, pattern, flags);
  }
  return flags;
}

}  // namespace enfilade
