#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "models/mesh_builder.h"
#include "models/plan_layout.h"

namespace enfilade {

/// A point on a wall's face where the wall's mesh, and all that meets it above and below, has a
/// vertex.
struct WallBreak {
  double along = 0;  ///< [m] from the edge's first corner
  glm::dvec2 point{0};
  double shade = 1;  ///< 0…1, darker toward corners
};

/// Where the faces of an outline have vertices, edge by edge, both corners included.
using OutlineBreaks = std::vector<std::vector<WallBreak>>;

/// `shade_corners`: also breaks near the corners, which grow dark toward them.
OutlineBreaks outlineBreaks(const Outline& outline, const Layout& layout, bool shade_corners);

/// How high walls stand and how their picture lies on them.
struct WallExtent {
  double floor = 0;   ///< [m] level that sills and heads are measured from
  double bottom = 0;  ///< [m] level
  double top = 3;     ///< [m] level
  double across = 1;  ///< [m] that the picture spans along the wall
  double up = 1;      ///< [m] that the picture spans upward
  double foot = 0;    ///< [m] level of the picture's foot
};

/// The faces of the walls, openings left out.  No T-junctions: every vertex on an edge is a vertex
/// of both sides.
void raiseWalls(const PlanStorey& plan, const Outline& outline, const Layout& layout,
                const OutlineBreaks& breaks, const WallExtent& extent, MeshBuilder& mesh);

/// The strip between the walls' faces of two storeys, whose vertices need not stand over one
/// another: from `low`, where the lower faces end, to `high`, where the upper ones begin.
void raiseStoreyJoint(const Outline& outline, const OutlineBreaks& below, const Outline& above,
                      const OutlineBreaks& breaks_above, double low, double high,
                      const WallExtent& extent, MeshBuilder& mesh);

/// The halves of the openings' reveals that belong to the area, from its walls' faces to the
/// middle of the wall: jambs, heads and raised sills go to `reveals`, thresholds to `thresholds`.
void raiseReveals(const PlanStorey& plan, const Outline& outline, const Layout& layout,
                  double reveal_size, double threshold_size, MeshBuilder& reveals,
                  MeshBuilder& thresholds);

}  // namespace enfilade
