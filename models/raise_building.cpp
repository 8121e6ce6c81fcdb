#include "models/raise_building.h"

#include <fmt/format.h>

#include "models/building_raiser.h"
#include "models/plan_layout.h"
#include "models/raise_fittings.h"
#include "models/raise_openings.h"
#include "models/raise_slabs.h"
#include "models/raise_trim.h"
#include "models/raise_walls.h"

namespace enfilade {
namespace {

constexpr double kBelowGround = 0.4;  // the facade goes on below the ground [m]
constexpr double kParapet = 0.45;     // above the roof [m]
constexpr double kParapetWidth = 0.35;
constexpr double kTrimSize = 0.5;
constexpr double kFloorEdgeShade = 0.78;
constexpr double kCeilingEdgeShade = 0.85;

void raiseRoomTrim(BuildingRaiser& raiser, std::size_t room, std::uint32_t node) {
  const FloorPlan& plan = raiser.plan();
  const Layout& layout = raiser.layout();
  const PlanRoom& look = plan.rooms[room];
  const Outline& outline = layout.rooms[room];
  MeshBuilder trim, frames;
  raiseTrim(plan, outline, layout, skirtingProfile(plan.floor), TrimGaps::kAtDoors, trim);
  raiseTrim(plan, outline, layout, corniceProfile(plan.floor + look.height), TrimGaps::kNowhere,
            trim);
  raiseArchitraves(plan, outline, layout, trim);
  raiser.addMesh(look.name + "-trim", node, look.trim, trim);
  for (const LayoutOpening& opening : layout.openings)
    if (opening.sides[0].room == static_cast<int>(room) && plan.openings[opening.plan].panes.x > 0)
      raiseWindowFrame(plan, opening, frames);
  raiser.addMesh(look.name + "-window-frames", node, look.trim, frames);
}

void raiseRoomShell(BuildingRaiser& raiser, std::size_t room, std::uint32_t node) {
  const FloorPlan& plan = raiser.plan();
  const Layout& layout = raiser.layout();
  const PlanRoom& look = plan.rooms[room];
  const Outline& outline = layout.rooms[room];
  const double top = plan.floor + look.height;
  const double floor_size = raiser.finish(look.floor).size;
  const OutlineBreaks breaks = outlineBreaks(outline, layout, true);
  MeshBuilder walls, reveals, floor, ceiling;
  raiseWalls(plan, outline, layout, breaks,
             {plan.floor, plan.floor, top, raiser.finish(look.walls).size, look.height}, walls);
  raiseSlab(outline, breaks, {SlabSide::kTop, plan.floor, floor_size, kFloorEdgeShade}, floor);
  raiseSlab(outline, breaks,
            {SlabSide::kUnderside, top, raiser.finish(look.ceiling).size, kCeilingEdgeShade},
            ceiling);
  raiseReveals(plan, outline, layout, kTrimSize, floor_size, reveals, floor);
  raiser.addMesh(look.name + "-walls", node, look.walls, walls);
  raiser.addMesh(look.name + "-floor", node, look.floor, floor);
  raiser.addMesh(look.name + "-ceiling", node, look.ceiling, ceiling);
  raiser.addMesh(look.name + "-reveals", node, look.trim, reveals);
}

std::vector<std::uint32_t> raiseRooms(BuildingRaiser& raiser) {
  const FloorPlan& plan = raiser.plan();
  PortalMarkers markers(raiser);
  std::vector<std::uint32_t> nodes;
  for (std::size_t room = 0; room < plan.rooms.size(); ++room) {
    const std::string& name = plan.rooms[room].name;
    nodes.push_back(raiser.addNode(name + "-room", kNone, glm::mat4(1),
                                   fmt::format(R"({{"cell":"{}"}})", name)));
    raiseRoomShell(raiser, room, nodes.back());
    raiseRoomTrim(raiser, room, nodes.back());
    for (const LayoutOpening& opening : raiser.layout().openings)
      if (opening.sides[0].room == static_cast<int>(room)) markers.add(opening, nodes.back());
    addBounds(raiser, room, nodes.back());
  }
  return nodes;
}

std::uint32_t raiseOutside(BuildingRaiser& raiser) {
  const FloorPlan& plan = raiser.plan();
  const Layout& layout = raiser.layout();
  const std::uint32_t node = raiser.addNode("outside");
  const OutlineBreaks breaks = outlineBreaks(layout.outside, layout, false);
  const double roof_level = plan.floor + plan.height, top = roof_level + kParapet;
  const double size = raiser.finish(plan.facade).size;
  MeshBuilder facade, reveals, coping, trim, roof, ground;
  raiseWalls(plan, layout.outside, layout, breaks,
             {plan.floor, plan.ground - kBelowGround, top, size, size}, facade);
  raiseRoof(layout.outside, breaks, top, roof_level, kParapetWidth, raiser.finish(plan.roof).size,
            coping, roof);
  raiseReveals(plan, layout.outside, layout, kTrimSize, kTrimSize, reveals, reveals);
  raiseArchitraves(plan, layout.outside, layout, trim);
  raiseTrim(plan, layout.outside, layout, facadeCorniceProfile(top - 0.12), TrimGaps::kNowhere,
            trim);
  raiseGround(layout.outside, plan.ground, plan.margin, raiser.finish(plan.ground_finish).size,
              ground);
  raiser.addMesh("facade", node, plan.facade, facade);
  raiser.addMesh("facade-reveals", node, plan.outside_trim, reveals);
  raiser.addMesh("coping", node, plan.outside_trim, coping);
  raiser.addMesh("facade-trim", node, plan.outside_trim, trim);
  raiser.addMesh("roof", node, plan.roof, roof);
  raiser.addMesh("ground", node, plan.ground_finish, ground);
  return node;
}

}  // namespace

Building raiseBuilding(const FloorPlan& plan, std::uint64_t triangles, const std::string& subject,
                       const FurnitureLibrary* library) {
  const Layout layout = layOut(plan, subject);
  BuildingRaiser raiser(plan, layout);
  raiser.building().name = plan.name;
  raiser.building().copyright = plan.copyright;
  const auto room_nodes = raiseRooms(raiser);
  const std::uint32_t outside = raiseOutside(raiser);
  raiseFittings(raiser, room_nodes, outside, triangles, library, subject);
  return std::move(raiser.building());
}

}  // namespace enfilade
