#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "scene/geometry.h"

namespace enfilade {

using CellId = std::uint32_t;
using PortalId = std::uint32_t;

/// There is always one exterior cell, and it comes first.
inline constexpr CellId kExterior = 0;
inline constexpr CellId kNoCell = 0xffffffffu;

enum class PortalKind : std::uint8_t { kOpening, kDoor, kWindow };

/// A planar convex cross-section of free space between two cells.
struct Portal {
  std::string name;
  std::vector<glm::vec3>
      polygon;  ///< [m] counter-clockwise as seen from the front cell, at least 3
  Plane plane;  ///< of the polygon; positive in the front cell
  CellId front = kNoCell;
  CellId back = kNoCell;
  PortalKind kind = PortalKind::kOpening;
  bool two_way = true;  ///< false: seen through from the front cell only
  bool active = true;  ///< false: shut: its door's leaf is there, it shows no image, and nothing is
                       ///< seen through it
  /// [m] A shut one is seen through by an eye nearer than this, which may be between it and its
  /// leaf; from anywhere if the leaf does not fill it.  Not stored: see lookThroughShutPortals().
  float seen_within = 0;

  glm::vec3 center() const;  ///< centre of area
  float area() const;        ///< [m²]
  CellId cellBehind(bool from_front) const { return from_front ? back : front; }
};

/// A portal as seen from one of its sides.
struct PortalSide {
  PortalId portal = 0;
  bool from_front = true;  ///< the eye is on the front cell's side

  bool operator==(const PortalSide& other) const = default;
};

/// The number of a side among all sides: of portal 0 the front and the back, of portal 1 …
inline std::size_t sideIndex(PortalId portal, bool from_front) noexcept {
  return 2 * static_cast<std::size_t>(portal) + (from_front ? 0 : 1);
}

/// A room, or the exterior: a connected part of free space.
struct Cell {
  std::string name;
  int storey = 0;                 ///< index in CellGraph::storeys, of its floor; the exterior has 0
  Box bounds;                     ///< of its free space [m]
  float volume = 0;               ///< of its free space [m³]; 0 for the exterior
  float floor_area = 0;           ///< [m²]
  std::vector<PortalId> portals;  ///< in increasing order
};

struct Storey {
  std::string name;
  float floor_y = 0;  ///< [m]
};

/// Cells joined by portals.  Every line of sight from one cell into another crosses a portal
/// polygon.
struct CellGraph {
  std::vector<Storey> storeys;  ///< lowest first; at least one
  std::vector<Cell> cells;      ///< [0] is the exterior
  std::vector<Portal> portals;
};

/// The plane of a polygon (Newell's method), positive on the side from which it is
/// counter-clockwise.
Plane planeOf(const std::vector<glm::vec3>& polygon);

/// Fills every cell's list of portals from the portals' front and back.
void linkCells(CellGraph& graph);

/// What is wrong with the graph, a line each; empty if nothing is: cell ids out of range, polygons
/// that are not planar (1 cm), not convex, degenerate or wound against their plane, portals with
/// the same cell on both sides, cells but the exterior without a portal.
std::vector<std::string> diagnose(const CellGraph& graph);

/// What to say of a graph with no cell but the exterior: no fault, but nobody wants it.
inline constexpr const char* kNoRoom =
    "no room was found: the building is one cell, and nothing of it is culled";

}  // namespace enfilade
