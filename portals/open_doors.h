#pragma once

#include <cstdint>
#include <vector>

#include "portals/house.h"

namespace enfilade {

/// One flag an object: whether it is a door's that stands open, so that it is not drawn and no
/// obstacle.  All doors do but those in a portal that is shut (not active): whose box has its
/// middle within the portal's polygon, as seen along its normal, and no more than half a metre
/// before or behind it.
std::vector<std::uint8_t> openDoors(const House& house);

}  // namespace enfilade
