#pragma once

#include <unistd.h>

#include <filesystem>
#include <string>

#include "portals/house.h"

namespace enfilade::testing {

/// A folder of its own, gone with the object.
class TemporaryFolder {
 public:
  TemporaryFolder()
      : path_(std::filesystem::temp_directory_path() /
              ("enfilade-" + std::to_string(::getpid()) + "-" + std::to_string(count_++))) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() { std::filesystem::remove_all(path_); }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  static inline int count_ = 0;
  std::filesystem::path path_;
};

/// Two rooms with a door between them and a window to the exterior, three objects: a fixed one, the
/// door's leaf, the window's pane.
inline House smallHouse() {
  House house;
  house.info = {"0.1.0",
                "model \"ä\".glb",
                std::string(64, 'a'),
                {{"voxel_m", "0.1"}, {"doors", "IfcDoor*"}},
                {{"triangles", 3}, {"share", 0.125}},
                {"merged the pantry into the kitchen"},
                {{"porch", "exterior", {{1, 1, 1}, {1, 1.5f, 4.1f}}, {1, 1.3f, 3}}}};
  house.graph.storeys = {{"ground", -0.1f}, {"upper", 2.7f}};
  house.graph.cells.resize(3);
  house.graph.cells[1] = {"kitchen", 0, {{0, 0, 0}, {2, 2.4f, 3}}, 14.4f, 6, {}};
  house.graph.cells[2] = {"hall", 1, {{2, 0, 0}, {4, 2.4f, 3.1f}}, 14.5f, 6.1f, {}};
  Portal door;
  door.name = "door";
  door.kind = PortalKind::kDoor;
  door.polygon = {{2, 0, 2}, {2, 0, 1.1f}, {2, 2.1f, 1.1f}, {2, 2.1f, 2}};
  door.plane = planeOf(door.polygon);
  door.front = 2;
  door.back = 1;
  Portal window = door;
  window.name = "window";
  window.kind = PortalKind::kWindow;
  for (glm::vec3& corner : window.polygon) corner.x = 0.1f / 3;
  window.plane = planeOf(window.polygon);
  window.front = 1;
  window.back = kExterior;
  window.two_way = false;
  window.active = false;
  house.graph.portals = {door, window};
  linkCells(house.graph);
  std::vector<CellGrid::Label> labels;
  for (int i = 0; i < 8 * 4 * 6; ++i) {
    labels.push_back(static_cast<CellGrid::Label>(i % 11 == 0 ? CellGrid::kSolidVoxel : i / 64));
  }
  house.grid = CellGrid({-0.1f, 0, 0}, 0.5f, {8, 4, 6}, labels);

  house.building.name = "small";
  house.building.vertex_arrays.push_back(
      {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}}, {}, {}});
  house.building.materials.push_back({.name = "plaster"});
  Mesh mesh{"triangle", 0, 0, {0, 1, 2}, {}};
  for (const glm::vec3& p : house.building.vertex_arrays[0].positions) mesh.bounds.extend(p);
  house.building.meshes.push_back(mesh);
  for (std::uint32_t i = 0; i < 3; ++i) {
    Node node;
    node.name = "node " + std::to_string(i);
    node.world_from_node[3] = glm::vec4(i, 0.1f, 0.2f, 1);
    house.building.nodes.push_back(node);
    house.building.objects.push_back({i, 0});
  }
  house.object_roles = {ObjectRole::kFixed, ObjectRole::kDoor, ObjectRole::kGlass};
  house.object_cells = {{1, 2}, {}, {1, 2}};
  house.switch_distance = 1.7f;
  house.eye_height = 1.55f;
  return house;
}

}  // namespace enfilade::testing
