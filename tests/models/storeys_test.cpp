// Plans of several storeys: what fits on what, and that stairwells leave no gap.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "models/floor_plan.h"
#include "models/plan_layout.h"
#include "models/polygon.h"
#include "models/polygon_holes.h"
#include "models/raise_building.h"
#include "scene/polygon_triangles.h"
#include "tests/models/edge_balance.h"
#include "tests/models/plan_complaints.h"

namespace enfilade {
namespace {

/// A hall of 6 × 4 m with a window, above it two rooms with others, and two wells into one of them.
const std::string kPlan = R"json({
  "enfilade": "plan", "version": 1, "name": "tower", "triangles": 2000,
  "outside": {"ground": -0.3, "facade": "white", "roof": "white", "floor": "white",
              "trim": "white"},
  "storeys": [
    {"height": 3.2, "wall_thickness": 0.2, "defaults": {"height": 2.8, "ceiling": "white", "trim": "white"},
     "walls": [{"from": [0, 0], "to": [6, 0]}, {"from": [6, 0], "to": [6, 4]},
               {"from": [6, 4], "to": [0, 4]}, {"from": [0, 4], "to": [0, 0]}],
     "rooms": [{"name": "hall", "at": [2, 2], "floor": "white", "walls": "white"}],
     "openings": [{"kind": "door", "between": ["hall", "exterior"], "at": [0, 2], "width": 1, "head": 2.1},
                  {"kind": "window", "between": ["hall", "exterior"], "at": [2.6, 4], "width": 1.2,
                   "sill": 0.9, "head": 2.1}]},
    {"name": "attic", "height": 3, "wall_thickness": 0.2,
     "defaults": {"height": 2.6, "ceiling": "white", "trim": "white"},
     "walls": [{"from": [6, 4], "to": [0, 4]}, {"from": [0, 4], "to": [0, 0]},
               {"from": [0, 0], "to": [6, 0]}, {"from": [6, 0], "to": [6, 4]},
               {"from": [4, 0], "to": [4, 4]}],
     "rooms": [{"name": "loft", "at": [2, 2], "floor": "white", "walls": "white"},
               {"name": "nook", "at": [5, 2], "floor": "white", "walls": "white"}],
     "openings": [{"kind": "door", "between": ["loft", "nook"], "at": [4, 2], "width": 1, "head": 2.1},
                  {"kind": "window", "between": ["loft", "exterior"], "at": [2, 4], "width": 1.2,
                   "sill": 0.9, "head": 2.1}],
     "wells": [{"between": ["loft", "hall"], "from": [2.2, 1.2], "to": [0.5, 0.4]},
               {"between": ["loft", "hall"], "from": [0.6, 1.9], "to": [1.6, 3.1]}]}
  ],
  "pieces": {},
  "finishes": {"white": {"colors": ["#ffffff"]}}
})json";

std::string with(const std::string& from, const std::string& to) {
  return replacedIn(kPlan, from, to);
}

Building raised(const std::string& text) {
  return raiseBuilding(parseFloorPlan(text, "tower.json"), 2000, "tower.json");
}

void expectComplaint(const std::string& text, const std::string& about) {
  const std::string what = complaintAbout(text, "tower.json");
  EXPECT_NE(what.find(about), std::string::npos) << "it says: " << what;
}

TEST(Storeys, BeginWhereTheStoreyBelowEnds) {
  const FloorPlan plan = parseFloorPlan(kPlan, "tower.json");
  ASSERT_EQ(plan.storeys.size(), 2u);
  EXPECT_EQ(plan.storeys[1].floor, 3.2);
  EXPECT_EQ(plan.storeys[1].top(), 6.2);
  expectComplaint(with("\"name\": \"attic\"", "\"name\": \"attic\", \"floor\": 3"),
                  "storeys[1].floor: must be 3.2, where the storey below ends");
}

TEST(Storeys, OfRoomsWithWellsAreClosedByTheirPortalsExactly) {
  const Building tower = raised(kPlan);
  const auto portals = namedPortals(tower);
  EXPECT_EQ(portals.size(), 6u);
  for (const std::string room : {"hall", "loft", "nook"}) {
    expectClosed(tower, portals, room);
  }
}

TEST(Storeys, OfOneFacadeAreClosedThoughTheirWindowsStandNotOverOneAnother) {
  const Building tower = raised(kPlan);
  EdgeBalance edges;
  const auto shell = worldTriangles(tower, [&](const Object& object) {
    const std::string& name = tower.nodes[object.node].name;
    return name == "facade" || name == "facade-reveals" || name == "coping" || name == "roof";
  });
  for (const WorldTriangle& t : shell) edges.add(t);
  edges.addPortals(namedPortals(tower), "exterior");
  for (const auto& [a, b] : edges.open()) EXPECT_LT(std::max(a.y, b.y), -0.4f);
}

TEST(Storeys, HaveTheirWellsPortalsInTheUpperFloorFacingUp) {
  int wells = 0;
  for (const NamedPortal& portal : namedPortals(raised(kPlan))) {
    if (portal.to != "hall") continue;
    ++wells;
    EXPECT_EQ(portal.room, "loft-room");
    for (const glm::vec3& corner : portal.corners) EXPECT_EQ(corner.y, 3.2f);
    EXPECT_GT(
        glm::cross(portal.corners[1] - portal.corners[0], portal.corners[2] - portal.corners[0]).y,
        0);
  }
  EXPECT_EQ(wells, 2);
}

TEST(Storeys, MustStandOnTheOuterWallsBelow) {
  expectComplaint(with("{\"from\": [0, 0], \"to\": [6, 0]}, {\"from\": [6, 0], \"to\": [6, 4]},\n"
                       "               {\"from\": [6, 4], \"to\": [0, 4]}, {\"from\": [0, 4]",
                       "{\"from\": [0, 0], \"to\": [7, 0]}, {\"from\": [7, 0], \"to\": [7, 4]},\n"
                       "               {\"from\": [7, 4], \"to\": [0, 4]}, {\"from\": [0, 4]"),
                  "storey attic: its outer walls must stand on those of storey ground");
}

TEST(Storeys, MustLeaveRoomForTheFloorAbove) {
  expectComplaint(with("\"height\": 2.8", "\"height\": 3.18"), "room hall: is 3.180 m high");
}

TEST(Storeys, HaveRoomsOfDifferentNames) {
  expectComplaint(with("\"name\": \"nook\"", "\"name\": \"hall\""),
                  "two rooms are called \"hall\"");
}

TEST(Storeys, SayOnWhichStoreyAWallEndsInTheOpen) {
  expectComplaint(with("\"to\": [4, 4]", "\"to\": [4, 3]"),
                  "storey attic: walls[4] ends in the open");
}

TEST(PlanWell, MustKeepFromWallsAndOtherWells) {
  expectComplaint(with("\"to\": [0.5, 0.4]", "\"to\": [0.5, 0.12]"),
                  "storeys[1].wells[0]: must lie in loft, 0.05 m from its walls");
  expectComplaint(with("\"from\": [0.6, 1.9]", "\"from\": [0.6, 1.22]"),
                  "comes too near to wells[0]");
}

TEST(PlanWell, MustJoinARoomAboveToARoomBelow) {
  expectComplaint(with("[\"loft\", \"hall\"]", "[\"hall\", \"loft\"]"),
                  "no room \"hall\" on storey attic");
  expectComplaint(with("\"name\": \"hall\"", "\"name\": \"yard\""), "there is no room \"hall\"");
}

TEST(PlanWell, IsWideEnoughToSeeThrough) {
  expectComplaint(with("\"to\": [0.5, 0.4]", "\"to\": [0.5, 1.1]"), "is narrower than 0.3 m");
}

TEST(PolygonHoles, LeaveTheAreaBetweenThem) {
  const std::vector<glm::dvec2> outer{{0, 0}, {10, 0}, {10, 6}, {6, 6}, {6, 3}, {0, 3}};
  const std::vector<std::vector<glm::dvec2>> holes{{{1, 1}, {2, 1}, {2, 2}, {1, 2}},
                                                   {{7, 4}, {9, 4}, {9, 5}, {7, 5}},
                                                   {{3, 1}, {4, 1}, {4, 2}, {3, 2}}};
  std::vector<glm::dvec2> points;
  for (const JoinedCorner& corner : joinHoles(outer, holes)) points.push_back(corner.point);
  EXPECT_NEAR(signedArea(points), 42 - 4, 1e-9);
  double covered = 0;
  for (const auto& [a, b, c] : triangulate(points)) {
    const std::vector<glm::dvec2> triangle{points[a], points[b], points[c]};
    EXPECT_GE(signedArea(triangle), 0);
    covered += signedArea(triangle);
    const glm::dvec2 middle = (points[a] + points[b] + points[c]) / 3.0;
    if (signedArea(triangle) < 1e-9) continue;
    for (const auto& hole : holes) EXPECT_FALSE(containsPoint(hole, middle));
  }
  EXPECT_NEAR(covered, 42 - 4, 1e-9);
}

}  // namespace
}  // namespace enfilade
