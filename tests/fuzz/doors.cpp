#include "app/door_timeline.h"
#include "tests/fuzz/soundness.h"
#include "tests/fuzz/targets.h"

namespace enfilade::fuzz {
namespace {

Portal portalAt(float x, const char* name) {
  Portal portal;
  portal.name = name;
  portal.polygon = {{x, 0, 0}, {x, 0, -1}, {x, 2, -1}, {x, 2, 0}};
  portal.plane = planeOf(portal.polygon);
  portal.kind = PortalKind::kDoor;
  return portal;
}

/// Three rooms in a row: of the two doors between them one has a leaf, the other is shut.
House houseOfTwoDoors() {
  House house;
  house.graph.storeys.push_back({"ground", 0});
  house.graph.cells.resize(4);
  house.graph.portals = {portalAt(0, "door-hall-kitchen"), portalAt(5, "door-kitchen-yard")};
  for (PortalId id = 0; id < 2; ++id) {
    house.graph.portals[id].front = id + 1;
    house.graph.portals[id].back = id + 2;
  }
  house.graph.portals[1].active = false;
  linkCells(house.graph);
  Building& building = house.building;
  building.materials.emplace_back();
  building.nodes.emplace_back();
  building.vertex_arrays.push_back(
      {{{0, 0, 0}, {0, 0, -1}, {0, 2, -1}}, std::vector(3, glm::vec3(1, 0, 0)), {}, {}});
  building.meshes.push_back({"leaf", 0, 0, {0, 1, 2}, {{0, 0, -1}, {0, 2, 0}}});
  building.objects.push_back({0, 0});
  house.object_roles.push_back(ObjectRole::kDoor);
  house.object_cells.push_back({1, 2});
  return house;
}

}  // namespace

void doors(Bytes input) {
  static const House house = houseOfTwoDoors();
  const CameraPath path = decodeCameraPath(input, "tour.json");
  requireSound(path);
  const DoorTimeline timeline(path, house, "tour.json");
  for (const TimedPose& pose : path.poses) {
    const std::vector<std::uint8_t>* open = timeline.at(pose.time);
    require(open == nullptr ? path.doors.empty() : open->size() == house.graph.portals.size(),
            "a flag for each portal");
  }
}

}  // namespace enfilade::fuzz
