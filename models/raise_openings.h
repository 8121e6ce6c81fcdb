#pragma once

#include "models/building_raiser.h"

namespace enfilade {

/// The fixed frame and glazing bars of a window: a lattice that stands in the reveal, wholly on the
/// room's side of the wall's middle, so that it belongs to that room and crosses no portal.
void raiseWindowFrame(const PlanStorey& plan, const LayoutOpening& opening, MeshBuilder& mesh);

/// Adds the nodes that name a room's cells and portals for whoever reads the model: `TO-portal`
/// (with -2, -3 … from the second on), a quad that fills the opening in the middle of its wall,
/// counter-clockwise as seen from the room `node`; `extras.enfilade` is
/// {"portal": {"kind": "door", "to": "hall"}}.
class PortalMarkers {
 public:
  explicit PortalMarkers(BuildingRaiser& raiser) : raiser_(raiser) {}
  void add(const PlanStorey& storey, const LayoutOpening& opening, std::uint32_t room_node);
  /// Of a well, in the plane of the floor that it is cut through, seen from the upper room.
  void add(const PlanWell& well, double level, std::uint32_t upper_room_node);

 private:
  void addQuad(MeshBuilder& quad, const std::string& to, const char* kind, std::uint32_t node);

  BuildingRaiser& raiser_;
  std::map<std::string, int> count_;  ///< portals so far, by where they lead
};

/// Adds `ROOM-bound` (several, numbered, if the room is not convex): closed convex meshes that fill
/// the room between its walls' faces, its floor and its ceiling.
void addBounds(BuildingRaiser& raiser, const PlanStorey& storey, const Layout& layout,
               std::size_t room, std::uint32_t room_node);

}  // namespace enfilade
