// Plans that are wrong, by what is wrong with them, and a small one that is right.
#include "models/floor_plan.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

#include "models/patterns.h"
#include "models/plan_layout.h"
#include "models/polygon.h"
#include "models/shapes.h"
#include "tests/models/plan_complaints.h"

namespace enfilade {
namespace {

/// Two rooms of 4 × 4 m (centre lines), west and east, a door between, one out, and a window.
const std::string kPlan = R"json({
  "enfilade": "plan", "version": 1, "name": "two", "triangles": 2000,
  "outside": {"ground": -0.1, "facade": "white", "roof": "white", "floor": "white",
              "trim": "white"},
  "storeys": [{
    "height": 3.2, "wall_thickness": 0.2,
    "defaults": {"height": 2.8, "ceiling": "white", "trim": "white"},
    "walls": [
      {"from": [0, 0], "to": [8, 0]}, {"from": [8, 0], "to": [8, 4]},
      {"from": [8, 4], "to": [0, 4]}, {"from": [0, 4], "to": [0, 0]},
      {"from": [4, 0], "to": [4, 4]}
    ],
    "rooms": [
      {"name": "west", "at": [2, 2], "floor": "white", "walls": "white"},
      {"name": "east", "at": [6, 2], "floor": "white", "walls": "white"}
    ],
    "openings": [
      {"kind": "door", "between": ["west", "east"], "at": [4, 2], "width": 1, "head": 2.1},
      {"kind": "door", "between": ["west", "exterior"], "at": [0, 2], "width": 1, "head": 2.1},
      {"kind": "window", "between": ["east", "exterior"], "at": [6, 4], "width": 1.2, "sill": 0.9,
       "head": 2.1, "panes": [2, 2]}
    ],
    "fittings": [{"piece": "jar", "room": "east", "at": [7, 1]}]
  }],
  "pieces": {"jar": {"shape": "vase", "finish": "white", "height": 0.5}},
  "finishes": {"white": {"colors": ["#ffffff"]}}
})json";

std::string with(const std::string& from, const std::string& to) {
  return replacedIn(kPlan, from, to);
}

std::string complaint(const std::string& text) { return complaintAbout(text, "two.json"); }

void expectComplaint(const std::string& text, const std::string& about) {
  const std::string what = complaint(text);
  EXPECT_NE(what.find(about), std::string::npos) << "it says: " << what;
}

TEST(FloorPlan, RaisesASmallHouse) { EXPECT_EQ(complaint(kPlan), "none"); }

TEST(FloorPlan, RaisesTheExampleOfItsDescription) {
  std::ifstream file(ENFILADE_SOURCE_DIR "/models/README.md");
  std::stringstream stream;
  stream << file.rdbuf();
  const std::string text = stream.str();
  const std::size_t from = text.find("```json") + 7;
  ASSERT_GT(from, 7u);
  EXPECT_EQ(complaint(text.substr(from, text.find("```", from) - from)), "none");
}

TEST(FloorPlan, DescribesEveryShapeAndPattern) {
  std::ifstream file(ENFILADE_SOURCE_DIR "/models/README.md");
  std::stringstream stream;
  stream << file.rdbuf();
  for (const auto& names : {shapeNames(), patternNames()})
    for (const std::string& name : names)
      EXPECT_NE(stream.str().find("`" + name + "`"), std::string::npos) << name;
}

TEST(FloorPlan, RejectsTextThatIsNotJson) { expectComplaint("{", "is not JSON"); }

TEST(FloorPlan, RejectsAnotherDocument) {
  expectComplaint(with("\"plan\"", "\"tour\""), "enfilade: must be \"plan\"");
}

TEST(FloorPlan, RejectsANewerVersion) {
  expectComplaint(with("\"version\": 1", "\"version\": 2"), "version: must be from 1 to 1, is 2");
}

TEST(FloorPlan, RejectsAMisspeltKeyAndNamesThoseItKnows) {
  expectComplaint(with("\"sill\"", "\"sil\""), "openings[2]: does not know \"sil\"");
}

TEST(FloorPlan, RejectsANegativeThickness) {
  expectComplaint(with("\"to\": [8, 0]", "\"to\": [8, 0], \"thickness\": -0.2"),
                  "walls[0].thickness: must be from 0.05 to 2, is -0.2");
}

TEST(FloorPlan, RejectsAWallWithoutLength) {
  expectComplaint(with("\"from\": [4, 0], \"to\": [4, 4]", "\"from\": [4, 0], \"to\": [4, 0]"),
                  "walls[4]: is shorter");
}

TEST(FloorPlan, RejectsTextWhereANumberBelongs) {
  expectComplaint(with("\"width\": 1,", "\"width\": \"wide\","), "width: must be a number");
}

TEST(FloorPlan, RejectsAPointOfThreeNumbers) {
  expectComplaint(with("\"at\": [4, 2]", "\"at\": [4, 2, 1]"), "openings[0].at: must be [x, z]");
}

TEST(FloorPlan, RejectsAHeadBelowItsSill) {
  expectComplaint(with("\"sill\": 0.9", "\"sill\": 2.5"), "head: must be 0.2 m above the sill");
}

TEST(FloorPlan, RejectsTwoRoomsOfOneName) {
  expectComplaint(with("\"name\": \"east\"", "\"name\": \"west\""), "two rooms are called");
}

TEST(FloorPlan, RejectsARoomCalledExterior) {
  expectComplaint(with("\"name\": \"east\"", "\"name\": \"exterior\""), "lies outside");
}

TEST(FloorPlan, RejectsANameThatWouldPassForAMarker) {
  expectComplaint(with("\"name\": \"east\"", "\"name\": \"east-portal-2\""), "\"-portal\"");
}

TEST(FloorPlan, RejectsAnOpeningToAnUnknownRoom) {
  expectComplaint(with("[\"west\", \"east\"]", "[\"west\", \"attic\"]"),
                  "openings[0]: there is no room \"attic\"");
}

TEST(FloorPlan, RejectsAFittingInAnUnknownRoom) {
  expectComplaint(with("\"room\": \"east\"", "\"room\": \"attic\""), "no room \"attic\"");
}

TEST(FloorPlan, RejectsAnUnknownPieceShapeFinishAndPattern) {
  expectComplaint(with("\"piece\": \"jar\"", "\"piece\": \"jug\""), "no piece \"jug\"");
  expectComplaint(with("\"vase\"", "\"vaze\""), "pieces.jar.shape: no shape is called that");
  expectComplaint(with("\"finish\": \"white\"", "\"finish\": \"black\""), "no finish \"black\"");
  expectComplaint(with("{\"colors\"", "{\"pattern\": \"tartan\", \"colors\""), "no pattern");
}

TEST(FloorPlan, RejectsAShapesUnknownOrImpossibleNumber) {
  expectComplaint(with("\"height\": 0.5", "\"hight\": 0.5"), "pieces.jar: vase has no \"hight\"");
  expectComplaint(with("\"height\": 0.5", "\"height\": -1"), "pieces.jar.height: must be from");
}

TEST(FloorPlan, RejectsAColourThatIsNone) {
  expectComplaint(with("#ffffff", "#fffff"), "finishes.white.colors[0]: must be a colour");
}

TEST(FloorPlan, ALampOfAPieceShinesWhereThePieceStands) {
  const std::string text =
      with("\"height\": 0.5", R"("height": 0.5, "light": {"at": [0, 0.4, 0.1], "candela": 60})");
  const Building building = raiseBuilding(parseFloorPlan(text, "two.json"), 2000, "two.json");
  ASSERT_EQ(building.lights.size(), 1u);
  EXPECT_EQ(building.lights[0].intensity, 60.0f);
  const glm::vec3 place(building.nodes[building.lights[0].node].world_from_node[3]);
  EXPECT_NEAR(glm::distance(place, glm::vec3(7, 0.4f, 1.1f)), 0, 1e-5);
}

TEST(FloorPlan, RejectsALampThatIsNone) {
  expectComplaint(with("\"height\": 0.5", R"("height": 0.5, "light": {"at": [0, 1, 0]})"),
                  "pieces.jar.light");
  expectComplaint(
      with("\"height\": 0.5", R"("height": 0.5, "light": {"at": [0, 1], "candela": 1})"),
      "must be [x, y, z]");
  expectComplaint(with("\"triangles\"", R"("bake_light": 1, "triangles")"), "bake_light");
}

TEST(PlanLayout, RejectsAWallThatEndsInTheOpen) {
  expectComplaint(with("\"to\": [4, 4]", "\"to\": [4, 3]"), "walls[4] ends in the open");
}

TEST(PlanLayout, RejectsWallsThatDoNotHangTogether) {
  expectComplaint(
      with("{\"from\": [4, 0], \"to\": [4, 4]}",
           "{\"from\": [4, 0], \"to\": [4, 4]}, {\"from\": [20, 0], \"to\": [22, 0]},"
           "{\"from\": [22, 0], \"to\": [22, 2]}, {\"from\": [22, 2], \"to\": [20, 0]}"),
      "fall apart into 2 groups");
}

TEST(PlanLayout, RejectsAWallOnAnother) {
  expectComplaint(with("{\"from\": [4, 0], \"to\": [4, 4]}",
                       "{\"from\": [4, 0], \"to\": [4, 4]}, {\"from\": [1, 0], \"to\": [3, 0]}"),
                  "lie on one another");
}

TEST(PlanLayout, RejectsMoreWallsAndCrossingsThanCouldBeLaidOut) {
  const auto crossing = [](int each) {
    std::string walls;
    for (int i = 0; i < each; ++i) {
      walls += fmt::format(R"({{"from": [{0}, -1], "to": [{0}, 999]}},)"
                           R"({{"from": [-1, {0}], "to": [999, {0}]}},)",
                           i);
    }
    return with("\"walls\": [", "\"walls\": [" + walls);
  };
  expectComplaint(crossing(50), "its walls meet in over 2048 places");
  expectComplaint(crossing(300), "walls in a storey; 512 at most");
}

TEST(PlanLayout, RejectsTwoRoomsInOneArea) {
  expectComplaint(with("\"at\": [6, 2]", "\"at\": [3, 2]"), "west and east share one area");
}

TEST(PlanLayout, RejectsAnAreaWithoutARoom) {
  expectComplaint(
      with("{\"from\": [4, 0], \"to\": [4, 4]}",
           "{\"from\": [4, 0], \"to\": [4, 4]}, {\"from\": [6.5, 0], \"to\": [6.5, 4]}"),
      "no room is named for the area");
}

TEST(PlanLayout, RejectsARoomOutsideTheWalls) {
  expectComplaint(with("{\"name\": \"east\"",
                       "{\"name\": \"shed\", \"at\": [30, 2], \"floor\": \"white\", "
                       "\"walls\": \"white\"}, {\"name\": \"east\""),
                  "room shed: no walls enclose its point");
}

TEST(PlanLayout, RejectsWallsThatLeaveNothingOfARoom) {
  std::string text = with("\"from\": [4, 0], \"to\": [4, 4]",
                          "\"from\": [1, 0], \"to\": [1, 4], \"thickness\": 2");
  text.replace(text.find("\"at\": [2, 2]"), 12, "\"at\": [0.5, 2]");
  expectComplaint(text, "leave nothing");
}

TEST(PlanLayout, RejectsAnOpeningInNoWall) {
  expectComplaint(with("\"at\": [4, 2]", "\"at\": [4.1, 2]"), "no wall runs through");
}

TEST(PlanLayout, RejectsAnOpeningBeyondTheEndOfItsWall) {
  expectComplaint(with("\"at\": [4, 2]", "\"at\": [4, 3.6]"), "reaches beyond its wall");
}

TEST(PlanLayout, RejectsAnOpeningHigherThanItsRoom) {
  expectComplaint(with("\"head\": 2.1", "\"head\": 2.9"), "is too high for west");
}

TEST(PlanLayout, RejectsAnOpeningBetweenOtherRoomsThanItSays) {
  expectComplaint(with("[\"west\", \"exterior\"]", "[\"east\", \"exterior\"]"),
                  "its wall stands between");
}

TEST(PlanLayout, RejectsOpeningsThatOverlap) {
  expectComplaint(with("\"openings\": [",
                       "\"openings\": [{\"kind\": \"window\", \"between\": [\"west\", \"east\"], "
                       "\"at\": [4, 1.2], \"width\": 1, \"sill\": 1, \"head\": 2},"),
                  "overlap");
}

TEST(PlanLayout, RejectsAFittingOutsideItsRoom) {
  expectComplaint(with("\"at\": [7, 1]", "\"at\": [3, 1]"), "fittings[0] (jar)");
}

TEST(PlanLayout, RejectsWhatWouldHangInAnOpening) {
  expectComplaint(with("\"at\": [7, 1]", "\"at\": [6, 3.8], \"height\": 1.5, \"on_wall\": true"),
                  "would hang in an opening");
}

TEST(PlanLayout, PutsRoomsBetweenTheFacesOfTheirWalls) {
  const FloorPlan plan = parseFloorPlan(kPlan, "two.json");
  const Layout layout = layOut(plan, "two.json").front();
  EXPECT_NEAR(signedArea(layout.rooms[0].corners()), 3.8 * 3.8, 1e-9);
  EXPECT_NEAR(signedArea(layout.outside.corners()), -8.2 * 4.2, 1e-9);
  ASSERT_EQ(layout.rooms[0].edges.size(), 4u);
  const OpeningSide& side = layout.openings[0].sides[0];
  EXPECT_NEAR(side.middle_first.x, 4, 1e-9);
  EXPECT_NEAR(side.first.x, 3.9, 1e-9);
  EXPECT_NEAR(side.inward.x, -1, 1e-9);
}

TEST(PlanLayout, JoinsWallsOfTwoThicknessesInOneLineByAStep) {
  const FloorPlan plan =
      parseFloorPlan(with("{\"from\": [0, 0], \"to\": [8, 0]}",
                          "{\"from\": [0, 0], \"to\": [2, 0]}, {\"from\": [2, 0], \"to\": [8, 0], "
                          "\"thickness\": 0.4}"),
                     "two.json");
  const Layout layout = layOut(plan, "two.json").front();
  EXPECT_EQ(layout.rooms[0].edges.size(), 6u);
  EXPECT_NEAR(signedArea(layout.rooms[0].corners()), 3.8 * 3.8 - 1.9 * 0.1, 1e-9);
}

}  // namespace
}  // namespace enfilade
