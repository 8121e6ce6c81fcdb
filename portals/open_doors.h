#pragma once

#include <cstdint>
#include <vector>

#include "portals/house.h"

namespace enfilade {

/// A door whose portal is shut (not active).
struct ShutDoor {
  std::uint32_t object = 0;
  PortalId portal = 0;
};

/// The doors in shut portals, by object, then portal: those whose box has its middle within the
/// portal's polygon, as seen along its normal, and no more than half a metre before or behind it.
std::vector<ShutDoor> shutDoors(const House& house);

/// One flag an object: whether it is a door's that stands open, so that it is not drawn and no
/// obstacle: all but shut ones.
std::vector<std::uint8_t> openDoors(const House& house);

}  // namespace enfilade
