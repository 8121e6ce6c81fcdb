#include "app/inspection.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/floor_plan.h"
#include "app/mesh_closure.h"
#include "scene/gltf_reader.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

using Json = nlohmann::json;

bool anyHolds(const std::vector<std::string>& lines, const std::string& text) {
  return std::any_of(lines.begin(), lines.end(),
                     [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

TEST(Inspection, CountsWhatIsInABuilding) {
  const House house = twoRoomHouse();
  const BuildingFacts facts = describeBuilding(house.building);
  EXPECT_EQ(facts.objects, house.building.objects.size());
  EXPECT_EQ(facts.triangles, 12 * facts.objects);
  EXPECT_EQ(facts.closed_meshes, facts.meshes) << "all are boxes";
  EXPECT_FALSE(facts.bounds.empty());
}

TEST(Inspection, NamesCannotCommandATerminalNorForgeLines) {
  House house = twoRoomHouse();
  const std::string evil = "\x1b[31mroom\n  nothing looks wrong\u009b";
  house.graph.cells[1].name = house.graph.storeys[0].name = house.graph.portals[0].name = evil;
  house.info.model_name = house.building.copyright = evil;
  house.info.log = {evil};
  for (const std::string& text :
       {houseText("house", house, {}), modelText("model.glb", house.building, {evil})}) {
    EXPECT_EQ(text.find('\x1b'), std::string::npos);
    EXPECT_EQ(text.find("\u009b"), std::string::npos);
    EXPECT_EQ(text.find("\n  nothing looks wrong"), std::string::npos);
    EXPECT_NE(text.find(" [31mroom   nothing looks wrong "), std::string::npos);
  }
}

TEST(Inspection, AMeshThatLacksATriangleIsOpen) {
  House house = twoRoomHouse();
  Mesh& mesh = house.building.meshes[0];
  EXPECT_TRUE(isClosed(house.building, mesh));
  const auto last = mesh.indices.end();
  const std::vector<std::uint32_t> degenerate = {0, 0, 1};
  mesh.indices.insert(last, degenerate.begin(), degenerate.end());
  EXPECT_TRUE(isClosed(house.building, mesh));
  mesh.indices.erase(mesh.indices.begin(), mesh.indices.begin() + 3);
  EXPECT_FALSE(isClosed(house.building, mesh));
}

TEST(Inspection, SuspectsAModelInMillimetres) {
  House house = twoRoomHouse();
  EXPECT_TRUE(buildingProblems(describeBuilding(house.building)).empty());
  for (VertexArrays& vertices : house.building.vertex_arrays) {
    for (glm::vec3& p : vertices.positions) p *= 1000.0f;
  }
  EXPECT_TRUE(anyHolds(buildingProblems(describeBuilding(house.building)), "metres?"));
}

TEST(Inspection, NamesTheCellsAndPortalsThatLookWrong) {
  House house = twoRoomHouse();
  for (Cell& cell : house.graph.cells) cell.volume = 30;
  EXPECT_TRUE(houseProblems(house).empty()) << houseProblems(house).front();
  house.graph.cells[2].volume = 0;
  house.graph.portals[0].active = false;
  for (auto& cells : house.object_cells) cells = {1};
  const std::vector<std::string> problems = houseProblems(house);
  EXPECT_TRUE(anyHolds(problems, "cell 2 ("));
  EXPECT_TRUE(anyHolds(problems, "has no volume"));
  EXPECT_TRUE(anyHolds(problems, "sees no object"));
  EXPECT_TRUE(anyHolds(problems, "portal 0 is shut"));
  EXPECT_TRUE(anyHolds(problems, "no door stands in portal 0: shut"));
}

TEST(Inspection, NamesInJsonMayHoldAnything) {
  House house = twoRoomHouse();
  house.graph.cells[1].name = "caf\xc3\xa9 \"quoted\" \xff";
  const Json json = Json::parse(houseJson("house", house, {}));
  EXPECT_EQ(json["cells"].size(), house.graph.cells.size());
  EXPECT_EQ(json["portals"][0]["kind"], "door");
}

TEST(Inspection, PointsToTheDoorsAndWindowsOfARealModel) {
  const std::string file = ENFILADE_SOURCE_DIR "/../shared/models/duplex.glb";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "the real buildings are not here";
  Warnings warnings;
  const std::string text = modelText("duplex.glb", readGltf(file, &warnings), warnings);
  EXPECT_NE(text.find("enfilade preprocess duplex.glb -o HOUSE --doors 'IfcDoor*' "
                      "--windows 'IfcWindow*'"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("26,684"), std::string::npos) << text;
}

TEST(FloorPlan, ShowsEveryCellAndPortalAndEscapesNames) {
  House house = twoRoomHouse();
  house.graph.cells[1].name = "<salt & pepper>";
  const std::string svg = floorPlanSvg(house);
  EXPECT_NE(svg.find("&lt;salt &amp; pepper&gt;"), std::string::npos);
  EXPECT_EQ(svg.find("<salt"), std::string::npos);
  EXPECT_NE(svg.find("<title>door 0: "), std::string::npos) << svg;
  EXPECT_NE(svg.find("1.00 x 2.10 m"), std::string::npos);
  EXPECT_NE(svg.find("5 m</text>"), std::string::npos) << "the scale bar";
  EXPECT_EQ(svg, floorPlanSvg(house));
  EXPECT_EQ(svg.find("leak"), std::string::npos);
}

TEST(FloorPlan, DrawsTheWayByWhichARoomLeaks) {
  House house = twoRoomHouse();
  house.info.leaks.push_back(
      {"the <den>", "exterior", {{1, 1, 1}, {2, 1, 1}, {2, 1, -3}}, {2, 1, -1}});
  const std::string svg = floorPlanSvg(house);
  EXPECT_NE(svg.find("the &lt;den&gt; leaks into exterior at height 1.00 m"), std::string::npos);
  EXPECT_NE(svg.find("<polyline"), std::string::npos);
  EXPECT_NE(svg.find(">leak</text>"), std::string::npos) << "what the line means";
}

}  // namespace
}  // namespace enfilade
