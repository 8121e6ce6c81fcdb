#pragma once

#include <span>

#include "portals/house.h"
#include "portals/open_doors.h"

namespace enfilade {

/// Portal::seen_within of a portal when it is shut [m]: 0 without a leaf, infinite if its leaves
/// leave more of it open than slits of a centimetre, or are glass, and otherwise how far they reach
/// from its plane.
float seenWithinWhenShut(const House& house, PortalId portal, std::span<const DoorLeaf> leaves);

/// Sets it for all portals of the house.
void lookThroughShutPortals(House& house, std::span<const DoorLeaf> leaves);

}  // namespace enfilade
