#include "preprocess/given_cells.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/preprocess/test_building.h"

namespace enfilade {
namespace {

/// Rooms "left" and "right" of 4 × 3 × 4 m beside each other along x, with a doorway at x = 4 and
/// one to the exterior at x = 8; cut as given.
class GivenCells : public testing::Test {
 protected:
  GivenCells() {
    test_.twoRooms({{1.5f, 2.5f, 0, 2.1f}}, {{1.5f, 2.5f, 0, 2.1f}});
    voxels_ = voxelise(test_.building, test_.roles, 0.1f);
    given_.graph.storeys = {{"ground", 0}};
    given_.graph.cells.resize(3);
    given_.graph.cells[0].name = "exterior";
    given_.graph.cells[1].name = "left";
    given_.graph.cells[1].bounds = {{0, 0, 0}, {4, 3, 4}};
    given_.graph.cells[2].name = "right";
    given_.graph.cells[2].bounds = {{4, 0, 0}, {8, 3, 4}};
    given_.graph.portals = {doorwayAt(4, "inner", 1, 2), doorwayAt(8, "outer", 2, 0)};
    given_.labels = {0, 1, 2};
  }

  /// Seen counter-clockwise from −x.
  static Portal doorwayAt(float x, const std::string& name, CellId front, CellId back) {
    Portal portal;
    portal.name = name;
    portal.polygon = {{x, 0, 1.5f}, {x, 0, 2.5f}, {x, 2.1f, 2.5f}, {x, 2.1f, 1.5f}};
    portal.plane = planeOf(portal.polygon);
    portal.front = front;
    portal.back = back;
    return portal;
  }

  CutCells cut() const {
    CutCells cells = cutCells(voxels_, givenCells(given_, voxels_));
    compareWithGiven(given_, cells);
    return cells;
  }

  static const Portal& portalOf(const CutCells& cells, const std::string& name) {
    return *std::find_if(cells.graph.portals.begin(), cells.graph.portals.end(),
                         [&](const Portal& p) { return p.name == name; });
  }
  static std::string cellAt(const CutCells& cells, const glm::vec3& p) {
    return cells.graph.cells[locate(cells.graph, cells.grid, p).cell].name;
  }

  TestBuilding test_;
  VoxelGrid voxels_;
  GivenGraph given_;
};

TEST_F(GivenCells, AreThoseOfTheirBoundsWithoutAGrid) {
  const CutCells cells = cut();
  EXPECT_TRUE(cells.log.empty()) << cells.log.front();
  ASSERT_EQ(cells.graph.cells.size(), 3u);
  ASSERT_EQ(cells.graph.portals.size(), 2u);
  EXPECT_EQ(cellAt(cells, {1, 1, 2}), "left");
  EXPECT_EQ(cellAt(cells, {7, 1, 2}), "right");
  EXPECT_EQ(cellAt(cells, {10, 1, 2}), "exterior");
  EXPECT_TRUE(diagnose(cells.graph).empty());
}

TEST_F(GivenCells, AreThoseOfTheGridWhateverTheirBounds) {
  const CutCells before = cut();
  given_.grid = before.grid;
  given_.graph.cells[1].bounds = given_.graph.cells[2].bounds = Box{{-9, -9, -9}, {9, 9, 9}};
  const CutCells again = cut();
  EXPECT_EQ(again.labels, before.labels);
  EXPECT_TRUE(again.log.empty()) << again.log.front();
}

TEST_F(GivenCells, FollowTheIdsOfTheGridThatTheyWereGiven) {
  given_.grid = cut().grid;
  std::swap(given_.labels[1], given_.labels[2]);  // so "left" names what lay right
  std::swap(given_.graph.cells[1].name, given_.graph.cells[2].name);
  const CutCells cells = cut();
  EXPECT_EQ(cellAt(cells, {1, 1, 2}), "left");
  EXPECT_EQ(cellAt(cells, {7, 1, 2}), "right");
}

TEST_F(GivenCells, BecomeOneWithoutThePortalBetweenThem) {
  given_.grid = cut().grid;
  given_.graph.portals.erase(given_.graph.portals.begin());
  const CutCells cells = cut();
  EXPECT_EQ(cells.graph.cells.size(), 2u);
  EXPECT_EQ(cellAt(cells, {1, 1, 2}), cellAt(cells, {7, 1, 2}));
  EXPECT_TRUE(std::any_of(cells.log.begin(), cells.log.end(), [](const std::string& line) {
    return line.ends_with("is no cell of its own");
  }));
}

TEST_F(GivenCells, AreCutInTwoByANewPortalAndANewCell) {
  given_.grid = cut().grid;
  Portal across = doorwayAt(6, "across", 2, 3);
  across.polygon = {{6, 0, 0.1f}, {6, 0, 3.9f}, {6, 3, 3.9f}, {6, 3, 0.1f}};
  across.plane = planeOf(across.polygon);
  given_.graph.portals.push_back(across);
  given_.graph.portals[1].front = 3;
  given_.graph.cells.push_back({});
  given_.graph.cells.back().name = "alcove";
  given_.graph.cells.back().bounds = {{6, 0, 0}, {8, 3, 4}};
  given_.labels.push_back(12);
  const CutCells cells = cut();
  EXPECT_TRUE(cells.log.empty()) << cells.log.front();
  EXPECT_EQ(cellAt(cells, {5, 1, 2}), "right");
  EXPECT_EQ(cellAt(cells, {7, 1, 2}), "alcove");
  EXPECT_EQ(portalOf(cells, "across").kind, PortalKind::kOpening);
}

TEST_F(GivenCells, SeeThroughAOneWayPortalFromItsFrontAsGiven) {
  given_.graph.portals[0].two_way = false;
  std::swap(given_.graph.portals[0].front, given_.graph.portals[0].back);
  const CutCells cells = cut();
  const Portal& inner = portalOf(cells, "inner");
  EXPECT_EQ(cells.graph.cells[inner.front].name, "right");
  EXPECT_EQ(cells.graph.cells[inner.back].name, "left");
  EXPECT_GT(inner.plane.signedDistance({7, 1, 2}), 0);
  EXPECT_FALSE(inner.two_way);
  EXPECT_TRUE(diagnose(cells.graph).empty());
  EXPECT_TRUE(cells.log.empty()) << cells.log.front();
}

TEST_F(GivenCells, SayWhichPortalJoinsOthersThanGiven) {
  given_.graph.portals[1].front = 1;
  const CutCells cells = cut();
  ASSERT_EQ(cells.log.size(), 1u);
  EXPECT_EQ(cells.log[0], "outer is given between left and exterior; it joins right and exterior");
}

TEST_F(GivenCells, AreNotCutTwiceByAPortalThatStandsTwice) {
  given_.graph.portals.push_back(given_.graph.portals[0]);
  given_.graph.portals.back().back = 0;
  given_.graph.portals.back().name += "#2";
  const CutCells cells = cut();
  EXPECT_EQ(cells.graph.portals.size(), 2u);
  EXPECT_TRUE(cells.log.empty()) << cells.log.front();
}

}  // namespace
}  // namespace enfilade
