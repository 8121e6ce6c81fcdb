#pragma once

#include "portals/cell_graph.h"

namespace enfilade {

/// Width and height of a portal [m]: along the horizontal in its plane, and across it.  Of a level
/// portal (a stair's opening): along its longest edge, and across that.
glm::vec2 portalSize(const Portal& portal);

/// Whether the portal lies level, more or less: one goes up or down through it.
bool isLevel(const Portal& portal);

}  // namespace enfilade
