#include "models/building_raiser.h"

#include <cmath>

#include "models/patterns.h"

namespace enfilade {

std::uint32_t BuildingRaiser::material(const std::string& finish_name) {
  const auto [place, fresh] = materials_.try_emplace(finish_name, kNone);
  if (!fresh) return place->second;
  const PlanFinish& look = finish(finish_name);
  Material material;
  material.name = finish_name;
  material.double_sided = look.double_sided;
  material.unlit = look.unlit && !to_be_lit_;
  if (look.pattern == "plain") {
    material.base_color = glm::vec4(glm::pow(look.colors[0], glm::dvec3(2.2)), 1.0);
  } else {
    material.image = static_cast<std::uint32_t>(building_.images.size());
    building_.images.push_back({finish_name, paintPattern(look), {}, {}});
  }
  building_.materials.push_back(material);
  place->second = static_cast<std::uint32_t>(building_.materials.size() - 1);
  return place->second;
}

std::uint32_t BuildingRaiser::markerMaterial() {
  if (marker_ == kNone) {
    Material material;
    material.name = "marker";
    material.base_color = {0.2f, 0.6f, 1.0f, 1.0f};
    material.double_sided = true;
    material.unlit = true;
    building_.materials.push_back(material);
    marker_ = static_cast<std::uint32_t>(building_.materials.size() - 1);
  }
  return marker_;
}

std::uint32_t BuildingRaiser::addNode(const std::string& name, std::uint32_t parent,
                                      const glm::mat4& world_from_node, const std::string& extras) {
  building_.nodes.push_back({name, parent, world_from_node, extras});
  return static_cast<std::uint32_t>(building_.nodes.size() - 1);
}

void BuildingRaiser::addMesh(const std::string& name, std::uint32_t parent,
                             const std::string& finish_name, MeshBuilder& mesh) {
  if (mesh.triangleCount() == 0) return;
  const std::uint32_t index = mesh.addTo(building_, name, material(finish_name), !to_be_lit_);
  addObject(addNode(name, parent), index);
}

}  // namespace enfilade
