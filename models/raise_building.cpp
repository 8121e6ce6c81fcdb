#include "models/raise_building.h"

#include <fmt/format.h>

#include "models/building_raiser.h"
#include "models/plan_layout.h"
#include "models/plan_storeys.h"
#include "models/raise_fittings.h"
#include "models/raise_openings.h"
#include "models/raise_slabs.h"
#include "models/raise_trim.h"
#include "models/raise_walls.h"
#include "scene/tessellate.h"

namespace enfilade {
namespace {

constexpr double kBelowGround = 0.4;  // the facade goes on below the ground [m]
constexpr double kParapet = 0.45;     // above the roof [m]
constexpr double kParapetWidth = 0.35;
constexpr double kJointHeight = 0.02;  // of the strip of facade between two storeys
constexpr double kTrimSize = 0.5;
constexpr double kEdgeWidth = 0.6;  // of the shade along the edges of floors and ceilings
constexpr double kFloorEdgeShade = 0.78;
constexpr double kCeilingEdgeShade = 0.85;
constexpr float kLitEdge = 0.4f;  // of faces that carry light [m]
constexpr float kCoarseEdge = 1.2f;

/// One storey while its rooms are raised.
struct StoreyRaiser {
  BuildingRaiser& raiser;
  const PlanStorey& plan;
  const Layout& layout;
  const std::vector<PlanWell>& wells_above;  ///< through the next storey's floor
};

std::vector<std::vector<glm::dvec2>> holesOf(const std::vector<PlanWell>& wells) {
  std::vector<std::vector<glm::dvec2>> holes;
  for (const PlanWell& well : wells) holes.push_back(cornersOf(well));
  return holes;
}

void raiseRoomTrim(const StoreyRaiser& storey, std::size_t room, std::uint32_t node) {
  const PlanRoom& look = storey.plan.rooms[room];
  const Outline& outline = storey.layout.rooms[room];
  MeshBuilder trim, frames;
  raiseTrim(storey.plan, outline, storey.layout, skirtingProfile(storey.plan.floor),
            TrimGaps::kAtDoors, trim);
  raiseTrim(storey.plan, outline, storey.layout, corniceProfile(storey.plan.floor + look.height),
            TrimGaps::kNowhere, trim);
  raiseArchitraves(storey.plan, outline, storey.layout, trim);
  storey.raiser.addMesh(look.name + "-trim", node, look.trim, trim);
  for (const LayoutOpening& opening : storey.layout.openings)
    if (opening.sides[0].room == static_cast<int>(room) &&
        storey.plan.openings[opening.plan].panes.x > 0)
      raiseWindowFrame(storey.plan, opening, frames);
  storey.raiser.addMesh(look.name + "-window-frames", node, look.trim, frames);
}

void raiseRoomShell(const StoreyRaiser& storey, std::size_t room, std::uint32_t node) {
  BuildingRaiser& raiser = storey.raiser;
  const PlanStorey& plan = storey.plan;
  const PlanRoom& look = plan.rooms[room];
  const Outline& outline = storey.layout.rooms[room];
  const double top = plan.floor + look.height;
  const double floor_size = raiser.finish(look.floor).size;
  const OutlineBreaks breaks = outlineBreaks(outline, storey.layout, true);
  const auto ceiling_holes = holesOf(wellsOf(look.name, 1, storey.wells_above));
  MeshBuilder walls, reveals, floor, ceiling;
  raiseWalls(plan, outline, storey.layout, breaks,
             {plan.floor, plan.floor, top, raiser.finish(look.walls).size, look.height, plan.floor},
             walls);
  raiseSlab(outline, breaks,
            {SlabSide::kTop, plan.floor, floor_size, kFloorEdgeShade, kEdgeWidth,
             holesOf(wellsOf(look.name, 0, plan.wells))},
            floor);
  raiseSlab(outline, breaks,
            {SlabSide::kUnderside, top, raiser.finish(look.ceiling).size, kCeilingEdgeShade,
             kEdgeWidth, ceiling_holes},
            ceiling);
  for (const auto& hole : ceiling_holes) raiseWell(hole, top, plan.top(), kTrimSize, reveals);
  raiseReveals(plan, outline, storey.layout, kTrimSize, floor_size, reveals, floor);
  raiser.addMesh(look.name + "-walls", node, look.walls, walls);
  raiser.addMesh(look.name + "-floor", node, look.floor, floor);
  raiser.addMesh(look.name + "-ceiling", node, look.ceiling, ceiling);
  raiser.addMesh(look.name + "-reveals", node, look.trim, reveals);
}

/// The nodes of a storey's rooms, in the plan's order.
std::vector<std::uint32_t> raiseRooms(const StoreyRaiser& storey, PortalMarkers& markers) {
  BuildingRaiser& raiser = storey.raiser;
  std::vector<std::uint32_t> nodes;
  for (std::size_t room = 0; room < storey.plan.rooms.size(); ++room) {
    const std::string& name = storey.plan.rooms[room].name;
    nodes.push_back(raiser.addNode(name + "-room", kNone, glm::mat4(1),
                                   fmt::format(R"({{"cell":"{}"}})", name)));
    raiseRoomShell(storey, room, nodes.back());
    raiseRoomTrim(storey, room, nodes.back());
    for (const LayoutOpening& opening : storey.layout.openings)
      if (opening.sides[0].room == static_cast<int>(room))
        markers.add(storey.plan, opening, nodes.back());
    for (const PlanWell& well : wellsOf(name, 0, storey.plan.wells))
      markers.add(well, storey.plan.floor, nodes.back());
    addBounds(raiser, storey.plan, storey.layout, room, nodes.back());
  }
  return nodes;
}

/// The facade of every storey, the strips that join them, their openings' reveals and mouldings.
void raiseFacade(BuildingRaiser& raiser, double top, MeshBuilder& facade, MeshBuilder& reveals,
                 MeshBuilder& trim) {
  const FloorPlan& plan = raiser.plan();
  const double size = raiser.finish(plan.facade).size, foot = plan.storeys[0].floor;
  OutlineBreaks below;
  for (std::size_t i = 0; i < plan.storeys.size(); ++i) {
    const PlanStorey& storey = plan.storeys[i];
    const Layout& layout = raiser.layout(i);
    const OutlineBreaks breaks = outlineBreaks(layout.outside, layout, false);
    const bool lowest = i == 0, highest = i + 1 == plan.storeys.size();
    const WallExtent extent{storey.floor,
                            lowest ? plan.ground - kBelowGround : storey.floor,
                            highest ? top : storey.top() - kJointHeight,
                            size,
                            size,
                            foot};
    raiseWalls(storey, layout.outside, layout, breaks, extent, facade);
    if (!lowest)
      raiseStoreyJoint(raiser.layout(i - 1).outside, below, layout.outside, breaks,
                       storey.floor - kJointHeight, storey.floor, extent, facade);
    raiseReveals(storey, layout.outside, layout, kTrimSize, kTrimSize, reveals, reveals);
    raiseArchitraves(storey, layout.outside, layout, trim);
    below = breaks;
  }
}

std::uint32_t raiseOutside(BuildingRaiser& raiser) {
  const FloorPlan& plan = raiser.plan();
  const PlanStorey& highest = plan.storeys.back();
  const Layout& layout = raiser.layout(plan.storeys.size() - 1);
  const std::uint32_t node = raiser.addNode("outside");
  const double roof_level = highest.top(), top = roof_level + kParapet;
  MeshBuilder facade, reveals, coping, trim, roof, ground;
  raiseFacade(raiser, top, facade, reveals, trim);
  raiseRoof(layout.outside, outlineBreaks(layout.outside, layout, false), top, roof_level,
            kParapetWidth, raiser.finish(plan.roof).size, coping, roof);
  raiseTrim(highest, layout.outside, layout, facadeCorniceProfile(top - 0.12), TrimGaps::kNowhere,
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

/// Splits the faces of all that stands, so that they can carry light; the ground and the mouldings,
/// which share no edges with the rest, into larger ones.
void splitForLight(BuildingRaiser& raiser, std::size_t most_added) {
  Building& building = raiser.building();
  std::vector<MeshToSplit> house, coarse;
  for (const Object& object : building.objects) {
    if (building.meshOf(object).material == raiser.markerMaterial()) continue;
    const std::string& name = building.nodes[object.node].name;
    const bool is_coarse = name == "ground" || name.ends_with("-trim");
    (is_coarse ? coarse : house).push_back({object.mesh, glm::mat4(1)});
  }
  splitLongEdges(building, house, kLitEdge, most_added);
  splitLongEdges(building, coarse, kCoarseEdge, most_added);
}

}  // namespace

Building raiseBuilding(const FloorPlan& plan, std::uint64_t triangles, const std::string& subject,
                       const FurnitureLibrary* library, bool to_be_lit) {
  const std::vector<Layout> layouts = layOut(plan, subject);
  BuildingRaiser raiser(plan, layouts, to_be_lit);
  raiser.building().name = plan.name;
  raiser.building().copyright = plan.copyright;
  PortalMarkers markers(raiser);
  std::vector<std::vector<std::uint32_t>> room_nodes;
  for (std::size_t i = 0; i < plan.storeys.size(); ++i) {
    const std::vector<PlanWell> none;
    const auto& above = i + 1 < plan.storeys.size() ? plan.storeys[i + 1].wells : none;
    room_nodes.push_back(raiseRooms({raiser, plan.storeys[i], layouts[i], above}, markers));
  }
  const std::uint32_t outside = raiseOutside(raiser);
  if (to_be_lit) splitForLight(raiser, triangles / 4);
  raiseFittings(raiser, room_nodes, outside, triangles, library, subject);
  return std::move(raiser.building());
}

}  // namespace enfilade
