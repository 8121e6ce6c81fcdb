#pragma once

#include <string>

#include "portals/house.h"

namespace enfilade {

/// The floor plan of a house as SVG: its storeys side by side, cut `slice_height` [m] above each
/// floor; cells coloured and named, solid walls dark, portals marked by kind, the ways by which
/// rooms leak, a scale bar.  Seen from above, +x to the right, +z down.  The same text for the same
/// house.
std::string floorPlanSvg(const House& house, float slice_height = 1.2f);

}  // namespace enfilade
