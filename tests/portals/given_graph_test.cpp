#include "portals/given_graph.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "scene/file_io.h"
#include "test_house.h"

namespace enfilade {
namespace {

using nlohmann::json;
using testing::smallHouse;
using testing::TemporaryFolder;

/// The house.json of a small house, edited, and read as a graph.
class GivenGraphFile : public ::testing::Test {
 protected:
  GivenGraphFile() {
    writeHouse(folder_ / "house", smallHouse());
    text_ = json::parse(readFile(file_));
  }

  GivenGraph read(const std::function<void(json&)>& edit = {}) {
    json edited = text_;
    if (edit) edit(edited);
    writeFileAtomically(file_, edited.dump(2));
    return readGivenGraph(file_);
  }

  /// What is said of an edited file, after its name.
  std::string complaint(const std::function<void(json&)>& edit) {
    try {
      read(edit);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      const std::string text = error.what();
      EXPECT_TRUE(text.starts_with(file_ + ": ")) << text;
      return text.substr(file_.size() + 2);
    }
    return "";
  }

  TemporaryFolder folder_;
  std::string file_ = folder_ / "house/house.json";
  json text_;
};

TEST_F(GivenGraphFile, OfAHouseIsItsGraph) {
  const House house = smallHouse();
  const GivenGraph given = read();
  ASSERT_EQ(given.graph.cells.size(), house.graph.cells.size());
  for (std::size_t c = 0; c < given.graph.cells.size(); ++c) {
    EXPECT_EQ(given.graph.cells[c].name, house.graph.cells[c].name);
    EXPECT_EQ(given.graph.cells[c].storey, house.graph.cells[c].storey);
    EXPECT_EQ(given.labels[c], c);
  }
  ASSERT_EQ(given.graph.portals.size(), house.graph.portals.size());
  for (std::size_t p = 0; p < given.graph.portals.size(); ++p) {
    const Portal& portal = given.graph.portals[p];
    EXPECT_EQ(portal.polygon, house.graph.portals[p].polygon);
    EXPECT_EQ(portal.front, house.graph.portals[p].front);
    EXPECT_EQ(portal.back, house.graph.portals[p].back);
    EXPECT_EQ(portal.kind, house.graph.portals[p].kind);
    EXPECT_EQ(portal.two_way, house.graph.portals[p].two_way);
    EXPECT_EQ(portal.active, house.graph.portals[p].active);
  }
  ASSERT_TRUE(given.grid.has_value());
  EXPECT_EQ(given.grid->size(), house.grid.size());
  EXPECT_EQ(given.doors, "IfcDoor*");
  EXPECT_EQ(given.windows, "");
}

TEST_F(GivenGraphFile, NeedsNoMoreThanStoreysCellsAndPortals) {
  std::filesystem::remove(folder_ / "house/cells.grid");
  const GivenGraph given = read([](json& text) {
    text = {{"storeys", {{{"name", "ground"}, {"floor_y", 0}}}},
            {"cells", {{{"id", 0}, {"name", "outside"}}, {{"id", 7}, {"name", "shed"}}}},
            {"portals",
             {{{"front", "shed"},
               {"back", 0},
               {"polygon", {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}}}}}}};
  });
  EXPECT_FALSE(given.grid.has_value());
  EXPECT_EQ(given.labels, (std::vector<CellId>{0, 7}));
  ASSERT_EQ(given.graph.portals.size(), 1u);
  const Portal& portal = given.graph.portals[0];
  EXPECT_EQ(portal.front, 1u);
  EXPECT_EQ(portal.back, kExterior);
  EXPECT_EQ(portal.kind, PortalKind::kOpening);
  EXPECT_TRUE(portal.two_way && portal.active);
  EXPECT_NEAR(portal.plane.normal.z, 1, 1e-6);
  EXPECT_EQ(given.graph.cells[1].portals, std::vector<PortalId>{0});
}

TEST_F(GivenGraphFile, KeepsTheIdsOfTheCellsThatAreLeft) {
  const GivenGraph given = read([](json& text) {
    text["cells"].erase(1);
    text["portals"].erase(1);
    text["portals"][0]["back"] = 0;
  });
  EXPECT_EQ(given.labels, (std::vector<CellId>{0, 2}));
  EXPECT_EQ(given.graph.portals[0].front, 1u);  // of id 2
}

TEST_F(GivenGraphFile, WithAMistakeIsRefusedAtItsPlace) {
  const auto corners = json::array({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0.5, 0.2, 0}, {0, 1, 0}});
  const std::pair<std::function<void(json&)>, std::string> mistakes[] = {
      {[](json& t) { t.erase("cells"); }, "cells is missing"},
      {[](json& t) { t["cells"][2]["id"] = 1; }, "cells[2] has the id of cells[1], 1"},
      {[](json& t) { t["cells"][2]["name"] = "kitchen"; }, "cells[2] has the name of cells[1]"},
      {[](json& t) { t["cells"].erase(0); }, "cells does not begin with the exterior, id 0"},
      {[](json& t) { t["cells"] = json::array(); }, "cells does not begin with the exterior"},
      {[](json& t) { t["cells"][1]["storey"] = 2; }, "cells[1].storey"},
      {[](json& t) { t["storeys"] = json::array(); }, "storeys is empty"},
      {[](json& t) { t["storeys"][1]["floor_y"] = -1; }, "storeys[1] is no higher"},
      {[](json& t) { t["portals"][1]["front"] = 9; }, "portals[1].front is 9, the id of no cell"},
      {[](json& t) { t["portals"][1]["back"] = "attic"; }, "portals[1].back is 'attic', the name"},
      {[](json& t) { t["portals"][0]["kind"] = "hatch"; }, "portals[0].kind is 'hatch'"},
      {[](json& t) { t["portals"][0]["active"] = 1; }, "portals[0].active is neither"},
      {[](json& t) { t["portals"][0]["polygon"].erase(1); }, ""},  // a triangle will do
      {[](json& t) {
         t["portals"][0]["polygon"] = {{0, 0, 0}};
       },
       "portals[0].polygon has fewer"},
      {[](json& t) { t["portals"][0]["back"] = t["portals"][0]["front"]; }, "same cell on both"},
      {[](json& t) { t["portals"][0]["polygon"][0][0] = 3; }, "portal 0 'door'"},  // not planar
      {[&](json& t) { t["portals"][0]["polygon"] = corners; }, "portal 0 'door'"},
      {[](json& t) { t = json::array(); }, "is not an object"},
  };
  for (const auto& [edit, reason] : mistakes) {
    const std::string said = complaint(edit);
    EXPECT_EQ(said.empty(), reason.empty()) << said;
    EXPECT_NE(said.find(reason), std::string::npos) << said << "\nwanted: " << reason;
  }
}

TEST_F(GivenGraphFile, ThatIsNoJsonIsRefused) {
  const std::string text = text_.dump();
  writeFileAtomically(file_, text.substr(0, text.size() / 2));
  EXPECT_THROW(readGivenGraph(file_), Error);
  writeFileAtomically(folder_ / "house/cells.grid", std::string("no grid"));
  EXPECT_THROW(read(), Error);
  EXPECT_THROW(readGivenGraph(folder_ / "nowhere.json"), Error);
}

}  // namespace
}  // namespace enfilade
