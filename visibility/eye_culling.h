#pragma once

#include "portals/cell_grid.h"
#include "visibility/portal_culling.h"

namespace enfilade {

/// Whether all that lies between the eye and its near plane is free space.  Where it is not, the
/// near plane may cut a wall open and show what no portal does.
bool nearPlaneIsInFreeSpace(const CellGrid& grid, const View& view);

/// Whether an eye is in free space.  In a voxel that a portal crosses, the portal itself is and the
/// wall around it is not.
bool eyeIsInFreeSpace(const CellGraph& graph, const CellGrid& grid, const glm::vec3& eye);

/// Whether an eye is lower than every storey's floor.  Outdoors that is under the ground, where one
/// looks into the rooms through the backs of their floors, which are not drawn.
bool isUnderEveryFloor(const CellGraph& graph, const glm::vec3& eye);

/// Portal culling from the cell that the eye is in.  An eye inside something solid, or whose near
/// plane reaches into it, or outdoors under every floor sees every cell whole and no image.
/// Conservative: draws more, never less.  The eye must be finite.
VisibleSet cullFromEye(const CellGraph& graph, const CellGrid& grid, const View& view,
                       const ShowAsImage& show_as_image = {});

}  // namespace enfilade
