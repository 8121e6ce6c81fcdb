#include "portals/open_doors.h"

#include <cmath>

#include "portals/polygon.h"

namespace enfilade {
namespace {

constexpr float kBeforePortal = 0.5f;  // [m] a leaf may stand at the wall's face
constexpr float kBesideHole = 0.05f;   // [m] its frame may lie beside the opening

bool standsIn(const Portal& portal, const glm::vec3& middle) {
  return std::abs(portal.plane.signedDistance(middle)) <= kBeforePortal &&
         distanceInPlane(portal.polygon, portal.plane, middle) <= kBesideHole;
}

}  // namespace

std::vector<DoorLeaf> doorLeaves(const House& house) {
  std::vector<DoorLeaf> leaves;
  for (std::uint32_t object = 0; object < house.object_roles.size(); ++object) {
    if (house.object_roles[object] != ObjectRole::kDoor) continue;
    const Box box = worldBounds(house.building, house.building.objects[object]);
    if (box.empty()) continue;
    for (PortalId p = 0; p < house.graph.portals.size(); ++p) {
      if (standsIn(house.graph.portals[p], box.center())) leaves.push_back({object, p});
    }
  }
  return leaves;
}

std::vector<std::uint8_t> openDoors(const House& house, std::span<const DoorLeaf> leaves) {
  std::vector<std::uint8_t> open = doorFlags(house.object_roles);
  for (const DoorLeaf& leaf : leaves) {
    if (!house.graph.portals[leaf.portal].active) open[leaf.object] = 0;
  }
  return open;
}

std::vector<std::uint8_t> openDoors(const House& house) {
  return openDoors(house, doorLeaves(house));
}

std::vector<std::uint8_t> closablePortals(const House& house) {
  std::vector<std::uint8_t> closable;
  for (const Portal& portal : house.graph.portals) closable.push_back(!portal.active);
  for (const DoorLeaf& leaf : doorLeaves(house)) closable[leaf.portal] = 1;
  return closable;
}

std::vector<PortalId> shutWithoutDoor(const House& house) {
  std::vector<std::uint8_t> has_door(house.graph.portals.size());
  for (const DoorLeaf& leaf : doorLeaves(house)) has_door[leaf.portal] = 1;
  std::vector<PortalId> shut;
  for (PortalId p = 0; p < house.graph.portals.size(); ++p) {
    if (!house.graph.portals[p].active && !has_door[p]) shut.push_back(p);
  }
  return shut;
}

}  // namespace enfilade
