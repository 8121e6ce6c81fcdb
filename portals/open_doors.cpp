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

std::vector<ShutDoor> shutDoors(const House& house) {
  std::vector<PortalId> shut;
  for (PortalId p = 0; p < house.graph.portals.size(); ++p) {
    if (!house.graph.portals[p].active) shut.push_back(p);
  }
  std::vector<ShutDoor> doors;
  if (shut.empty()) return doors;
  for (std::uint32_t object = 0; object < house.object_roles.size(); ++object) {
    if (house.object_roles[object] != ObjectRole::kDoor) continue;
    const Box box = worldBounds(house.building, house.building.objects[object]);
    if (box.empty()) continue;
    for (const PortalId p : shut) {
      if (standsIn(house.graph.portals[p], box.center())) doors.push_back({object, p});
    }
  }
  return doors;
}

std::vector<std::uint8_t> openDoors(const House& house) {
  std::vector<std::uint8_t> open = doorFlags(house.object_roles);
  for (const ShutDoor& door : shutDoors(house)) open[door.object] = 0;
  return open;
}

}  // namespace enfilade
