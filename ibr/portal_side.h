#pragma once

#include "ibr/image_parameters.h"
#include "portals/house.h"

namespace enfilade {

/// The height at which a viewer's eye is when looking at a side of a portal [m]: at the eye's
/// height above the floor there, but within the portal's own heights, since a distant eye's ray
/// comes to a high window almost level.
float eyeLevelBefore(const CellGraph& graph, const Portal& portal, bool from_front,
                     float eye_height);

/// Whether a side of a portal gets images.
bool getsImage(const Portal& portal, bool from_front);

/// A depth [m] that lies beyond the whole building as seen from any viewpoint before a portal.
double farDepth(const Building& building, const ImageParameters& parameters);

}  // namespace enfilade
