#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "portals/cell_graph.h"

namespace enfilade {

/// A portal that a segment passes.
struct PortalCrossing {
  PortalId portal = 0;
  bool from_front = true;  ///< out of the front cell into the back cell
  float distance = 0;      ///< [m] from the segment's origin; a little below 0 if it starts on it
};

/// Follows straight segments from cell to cell, by the portals of the cell that they are in.
/// Made once for a graph; for tens of millions of segments, from several threads at once.
/// Shut and one-way portals are passed like others: this is about where a point lies, not about
/// what is seen; the crossings say which portals lie on the way.
class PortalWalker {
 public:
  /// `tolerance` [m] [≥ 0]: a portal polygon is taken as this much larger on every side, and passed
  /// too by a segment that starts this much behind its plane.
  explicit PortalWalker(const CellGraph& graph, float tolerance = 0.01f);

  /// The cell at origin + distance · direction (unit), coming from `start`, the origin's cell.
  /// `distance` may be infinite.  Portals are passed in order of distance, each at most once, and
  /// only nearer than `distance`: a surface in the plane of a portal lies on the near side.
  /// `crossings` is cleared, then holds the portals passed; it allocates only to grow.
  CellId walk(CellId start, const glm::vec3& origin, const glm::vec3& direction, float distance,
              std::vector<PortalCrossing>& crossings) const;

 private:
  struct Side {
    Plane plane;  // positive in the cell whose side this is
    PortalId portal = 0;
    std::uint32_t first_edge = 0;
    std::uint32_t last_edge = 0;
    CellId behind = kNoCell;
    bool from_front = true;
  };

  float tolerance_;
  std::vector<std::uint32_t> first_;  // one a cell and one more, into sides_
  std::vector<Side> sides_;
  std::vector<Plane> edges_;  // through a polygon's edge, at right angles to its plane
};

}  // namespace enfilade
