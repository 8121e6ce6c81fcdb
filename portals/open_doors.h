#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "portals/house.h"

namespace enfilade {

/// A door's leaf and the portal that it shuts.
struct DoorLeaf {
  std::uint32_t object = 0;
  PortalId portal = 0;
};

/// The leaves of all portals, shut or not, by object, then portal: the doors whose box has its
/// middle within the portal's polygon, as seen along its normal, and no more than half a metre
/// before or behind it.
std::vector<DoorLeaf> doorLeaves(const House& house);

/// One flag an object: whether it is a door's that stands open, so that it is not drawn and no
/// obstacle: all but the leaves of shut portals (not active).
std::vector<std::uint8_t> openDoors(const House& house);
/// The same for leaves that are known.
std::vector<std::uint8_t> openDoors(const House& house, std::span<const DoorLeaf> leaves);

/// One flag a portal: whether it can be shut and opened, which takes a leaf, or that it is shut.
std::vector<std::uint8_t> closablePortals(const House& house);

/// The portals that are shut though no door stands in them: what is behind them is not drawn, and
/// nothing hides that.
std::vector<PortalId> shutWithoutDoor(const House& house);
inline constexpr const char* kShutWithoutDoor = "shut, what is behind it is a hole in the picture";

}  // namespace enfilade
