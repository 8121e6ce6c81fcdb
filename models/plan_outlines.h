#pragma once

#include <string>
#include <vector>

#include "models/plan_areas.h"
#include "models/plan_layout.h"

namespace enfilade {

/// The faces of the walls around every area, once their thickness is known.
struct PlanOutlines {
  std::vector<Outline> of_face;           ///< as PlanarFaces::faces; empty for masonry
  std::vector<std::size_t> edge_of_half;  ///< index in the outline of the half wall's face
};

/// Moves every area's edges inward by half of their walls' thickness; stretches of wall in one line
/// and of one thickness become one edge.  Throws Error (kBadInput) where walls leave no room.
PlanOutlines traceOutlines(const PlanStorey& plan, const PlanAreas& areas,
                           const std::string& subject);

}  // namespace enfilade
