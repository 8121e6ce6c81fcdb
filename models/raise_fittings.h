#pragma once

#include "models/building_raiser.h"
#include "models/furniture_library.h"

namespace enfilade {

/// Sets the plan's fittings in their places, children of `room_nodes` (by storey, as
/// PlanStorey::rooms) or of `outside_node`.  A piece is raised once and shared by all its places.
/// The curved surfaces are given as many triangles as bring the whole building nearest to
/// `triangles` (markers not counted), in fixed proportions; furniture of `library`'s catalogues has
/// its own, and credits of its makers are added to the building's copyright.  Throws Error
/// (kBadInput) for what would hang in an opening, or is in no catalogue.
void raiseFittings(BuildingRaiser& raiser,
                   const std::vector<std::vector<std::uint32_t>>& room_nodes,
                   std::uint32_t outside_node, std::uint64_t triangles,
                   const FurnitureLibrary* library, const std::string& subject);

}  // namespace enfilade
