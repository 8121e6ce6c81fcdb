#pragma once

#include <functional>
#include <vector>

#include "portals/cell_graph.h"
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

/// Nearer to a portal than this [m] the eye sees through it whole, both ways: more than the
/// distance of the near plane's corners, so that nothing vanishes while the eye passes.
inline constexpr float kNearPortal = 0.15f;

/// Portal polygons are taken as this much larger [m] on every side, since the jambs that they were
/// fitted to are only known to so much.
inline constexpr float kPortalMargin = 0.01f;

/// Whether an image is to be shown in place of what lies behind a portal.
using ShowAsImage = std::function<bool(const Portal& portal, PortalId id, bool from_front)>;

/// Recursive portal culling: from `eye_cell` through every active portal in view, clipping the view
/// volume by each portal polygon; the union of the regions over all paths.  An eye in a portal or
/// near it sees through it whole, without asking `show_as_image`. `eye_cell` is a cell of the
/// graph. Conservative: a set that is too large, never one too small. Source: Luebke & Georges,
/// Portals and Mirrors, 1995; Teller & Séquin 1991.
VisibleSet cullByPortals(const CellGraph& graph, const View& view, CellId eye_cell,
                         const ShowAsImage& show_as_image = {});

/// The same, but for an eye on one side of `portal` that sees only what lies behind it: what an
/// image of that portal shows.  `view.eye` need not stand in a cell; `eye_cell` of the result is
/// kNoCell, and `portal` itself is listed only if it is seen through other portals.  Shut and
/// one-way portals: those beyond count, `portal` itself is looked through in any case.
VisibleSet cullBehindPortal(const CellGraph& graph, const View& view, PortalId portal,
                            bool from_front);

}  // namespace enfilade
