#pragma once

#include <cstdint>
#include <string>

#include "models/floor_plan.h"
#include "models/furniture_library.h"
#include "scene/building.h"

namespace enfilade {

/// Raises a plan into a building of about `triangles` triangles: rooms first, in the plan's order,
/// storey by storey,
/// each a node `ROOM-room` with its walls, floor, ceiling, trim, portals and bounds; then the
/// node `outside` with facade, roof and ground; then the fittings.  Every room is closed but for
/// its portals.  Single-sided faces, vertices shared exactly.  Throws Error (kBadInput) as layOut
/// does; `subject` names the plan, `library`
/// has the furniture that it names.  `to_be_lit`: faces are split so that they can carry baked
/// light, within the number of triangles, and nothing is painted darker or bright by itself.
Building raiseBuilding(const FloorPlan& plan, std::uint64_t triangles, const std::string& subject,
                       const FurnitureLibrary* library = nullptr, bool to_be_lit = false);

}  // namespace enfilade
