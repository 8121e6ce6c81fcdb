#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "models/floor_plan.h"
#include "models/mesh_builder.h"
#include "models/plan_layout.h"
#include "scene/building.h"

namespace enfilade {

/// A building while it is being raised from a plan.
class BuildingRaiser {
 public:
  /// `to_be_lit`: without painted shades and unlit finishes, for light to be baked.
  BuildingRaiser(const FloorPlan& plan, const std::vector<Layout>& layouts, bool to_be_lit)
      : plan_(plan), layouts_(layouts), to_be_lit_(to_be_lit) {}

  const FloorPlan& plan() const { return plan_; }
  const Layout& layout(std::size_t storey) const { return layouts_[storey]; }
  Building& building() { return building_; }
  bool toBeLit() const { return to_be_lit_; }

  /// The material of a finish, painted when first asked for.
  std::uint32_t material(const std::string& finish);
  const PlanFinish& finish(const std::string& name) const { return plan_.finishes.at(name); }
  /// The material of portal and bound meshes.
  std::uint32_t markerMaterial();

  std::uint32_t addNode(const std::string& name, std::uint32_t parent = kNone,
                        const glm::mat4& world_from_node = glm::mat4(1),
                        const std::string& extras = {});
  void addObject(std::uint32_t node, std::uint32_t mesh) {
    building_.objects.push_back({node, mesh});
  }
  /// A mesh in world coordinates, in a node of its own under `parent`; nothing if it is empty.
  void addMesh(const std::string& name, std::uint32_t parent, const std::string& finish,
               MeshBuilder& mesh);

 private:
  const FloorPlan& plan_;
  const std::vector<Layout>& layouts_;
  bool to_be_lit_;
  Building building_;
  std::map<std::string, std::uint32_t> materials_;
  std::uint32_t marker_ = kNone;
};

}  // namespace enfilade
