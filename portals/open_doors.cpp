#include "portals/open_doors.h"

#include <algorithm>
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

std::vector<std::uint8_t> openDoors(const House& house) {
  std::vector<std::uint8_t> open = doorFlags(house.object_roles);
  const auto& portals = house.graph.portals;
  if (std::all_of(portals.begin(), portals.end(), [](const Portal& p) { return p.active; })) {
    return open;
  }
  for (std::size_t o = 0; o < open.size(); ++o) {
    if (open[o] == 0) continue;
    const Box box = worldBounds(house.building, house.building.objects[o]);
    if (box.empty()) continue;
    open[o] = std::none_of(portals.begin(), portals.end(), [&](const Portal& portal) {
      return !portal.active && standsIn(portal, box.center());
    });
  }
  return open;
}

}  // namespace enfilade
