#pragma once

#include <string>

#include "app/plan_marks.h"
#include "portals/house.h"

namespace enfilade {

/// The floor plan of a house as SVG: its storeys side by side, cut `slice_height` [m] above each
/// floor; cells coloured and named, solid walls dark, portals marked by kind, the ways by which
/// rooms leak, a scale bar.  Seen from above, +x to the right, +z down.  The same text for the same
/// house.
std::string floorPlanSvg(const House& house, float slice_height = 1.2f);

/// About all that is not the exterior, a metre more, and never beyond the grid.
PlanCrop planCrop(const House& house);

/// What a storey's part of the plan shows, as SVG elements from (0, 0) to the crop's size, to be
/// filled by the even-odd rule: cells (class `cell`), solid (class `wall`), portals, names, leaks.
std::string storeyDrawing(const House& house, std::size_t storey, float slice_height,
                          const PlanCrop& crop);

}  // namespace enfilade
