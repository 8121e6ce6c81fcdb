#pragma once

#include <functional>
#include <span>
#include <vector>

#include "portals/cell_graph.h"
#include "portals/house.h"
#include "visibility/screen_region.h"

namespace enfilade {

/// A cell and the parts of the screen through which it is seen, one for each path that leads to it.
struct VisibleCell {
  CellId cell = kNoCell;
  std::vector<ScreenRegion> regions;
};

/// A portal that the eye sees from one side, and where on screen.
struct VisiblePortal {
  PortalId portal = 0;
  bool from_front = true;             ///< the eye is on the front cell's side
  bool as_image = false;              ///< not traversed: an image is shown in its place
  std::vector<ScreenRegion> regions;  ///< one for each path that leads to it
};

/// What can be seen from an eye.
struct VisibleSet {
  CellId eye_cell = kNoCell;
  std::vector<VisibleCell> cells;      ///< by cell id; the eye's own cell has the whole screen
  std::vector<VisiblePortal> portals;  ///< by portal id, then front first
};

/// Whether an image is to be shown in place of what lies behind a portal.
using ShowAsImage = std::function<bool(const Portal& portal, PortalId id, bool from_front)>;

/// Recursive portal culling: from `eye_cell` through every active portal in view, clipping the view
/// volume by each portal polygon; the union of the regions over all paths.  An eye in a portal, on
/// its plane or near it sees through it whole. Conservative: a set that is too large, never one too
/// small. Source: Luebke & Georges, Portals and Mirrors, 1995; Teller & Séquin 1991.
VisibleSet cullByPortals(const CellGraph& graph, const View& view, CellId eye_cell,
                         const ShowAsImage& show_as_image = {});

/// The same, but for an eye that looks through `portal` from outside the cell behind it: what an
/// image of that portal shows. `view.eye` need not stand in a cell.
VisibleSet cullBehindPortal(const CellGraph& graph, const View& view, PortalId portal,
                            bool from_front);

/// The objects to draw, increasing: of the visible cells, those whose box may be seen through one
/// of the cell's regions. Doors are left out.
std::vector<std::uint32_t> visibleObjects(const House& house, const VisibleSet& set,
                                          std::span<const Box> world_bounds);

/// The objects to draw without any culling but that by the view frustum.  Doors are left out.
std::vector<std::uint32_t> objectsInFrustum(const House& house, const View& view,
                                            std::span<const Box> world_bounds);

/// worldBounds of every object, computed once.
std::vector<Box> objectBounds(const House& house);

}  // namespace enfilade
