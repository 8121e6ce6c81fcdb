#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "models/floor_plan.h"
#include "models/plan_areas.h"

namespace enfilade {

/// What an opening is to one of the two areas that it joins.  "First" and "second" go along that
/// area's wall, the area on the left.
struct OpeningSide {
  int room = kOutside;
  glm::dvec2 first{0}, second{0};                ///< jambs on the wall's face
  glm::dvec2 middle_first{0}, middle_second{0};  ///< jambs in the middle of the wall
  glm::dvec2 inward{0};                          ///< unit, away from the wall
};

struct LayoutOpening {
  std::size_t plan = 0;              ///< index in PlanStorey::openings
  std::array<OpeningSide, 2> sides;  ///< [0] is the room that states it
};

/// One side of an opening on an edge.
struct EdgeOpening {
  std::size_t opening = 0;    ///< index in Layout::openings
  int side = 0;               ///< index in its sides
  double start = 0, end = 0;  ///< [m] from the edge's first corner
};

/// A straight stretch of an area's outline: a wall's face.  The area lies to the left.
struct LayoutEdge {
  glm::dvec2 from{0}, to{0};
  glm::dvec2 inward{0};               ///< unit, into the area
  std::vector<EdgeOpening> openings;  ///< in order along the edge, disjoint

  double length() const { return glm::distance(from, to); }
  glm::dvec2 direction() const { return (to - from) / length(); }
  glm::dvec2 point(double along) const { return from + direction() * along; }
};

/// The faces of the walls around an area, in order, the area on the left.
struct Outline {
  std::vector<LayoutEdge> edges;

  std::vector<glm::dvec2> corners() const;
};

/// Where the walls' faces of one storey run, once their thickness is known.
struct Layout {
  std::vector<Outline> rooms;           ///< as PlanStorey::rooms
  Outline outside;                      ///< negative area: the exterior lies on its left
  std::vector<LayoutOpening> openings;  ///< as PlanStorey::openings

  Outline& outlineOf(int area) {
    return area == kOutside ? outside : rooms[static_cast<std::size_t>(area)];
  }
  const Outline& outlineOf(int area) const { return const_cast<Layout*>(this)->outlineOf(area); }
};

/// Lays every storey out: splits the walls where they meet, finds the areas they enclose, moves the
/// areas' edges by half the walls' thickness, cuts the openings.  Throws Error (kBadInput) for
/// walls that end in the open, overlap or fall apart; rooms in no area, or two in one; an area with
/// neither room nor "solid"; openings in no wall, outside their wall, overlapping, higher than a
/// room, or between other rooms than they say; fittings outside their room; and for storeys that do
/// not stand on one another (see checkStoreys).
std::vector<Layout> layOut(const FloorPlan& plan, const std::string& subject);

}  // namespace enfilade
