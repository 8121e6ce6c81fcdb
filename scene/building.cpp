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

bool matchesOne(const Building& building, const Object& object, const std::string& pattern) {
  const auto matches = [&](const std::string& name) {
    return fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
  };
  for (std::uint32_t n = object.node; n != kNone; n = building.nodes[n].parent) {
    if (matches(building.nodes[n].name)) return true;
  }
  return matches(building.materialOf(object).name);
}

}  // namespace

bool matchesName(const Building& building, const Object& object, const std::string& patterns) {
  std::istringstream stream(patterns);
  for (std::string pattern; std::getline(stream, pattern, ',');) {
    if (!pattern.empty() && matchesOne(building, object, pattern)) return true;
  }
  return false;
}

}  // namespace enfilade
