#include "app/plan_slice.h"

#include <gtest/gtest.h>

#include <random>

namespace enfilade {
namespace {

/// A slice drawn as text: digits are cells, '#' is solid.
PlanSlice drawn(const std::vector<std::string>& rows) {
  PlanSlice slice;
  slice.rows = static_cast<int>(rows.size());
  slice.columns = static_cast<int>(rows[0].size());
  for (const std::string& row : rows) {
    for (const char c : row) {
      slice.owner.push_back(c == '#' ? CellGrid::kSolidVoxel
                                     : static_cast<CellGrid::Label>(c - '0'));
    }
  }
  return slice;
}

/// Whether a point lies inside the loops by the even-odd rule: crossings of a ray to the right.
bool inside(const std::vector<std::vector<glm::ivec2>>& loops, float x, float y) {
  bool in = false;
  for (const auto& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::vec2 a = loop[i], b = loop[(i + 1) % loop.size()];
      if (a.x == b.x && (a.y > y) != (b.y > y) && a.x > x) in = !in;
    }
  }
  return in;
}

void expectOutlinesAreTheSquares(const PlanSlice& slice, CellGrid::Label label) {
  const auto loops = traceOutline(slice, label);
  for (int row = 0; row < slice.rows; ++row) {
    for (int column = 0; column < slice.columns; ++column) {
      EXPECT_EQ(inside(loops, static_cast<float>(column) + 0.5f, static_cast<float>(row) + 0.5f),
                slice.at(column, row) == label)
          << column << ", " << row;
    }
  }
}

TEST(PlanSlice, ARectangleIsFourCorners) {
  const auto loops = traceOutline(drawn({"0000", "0110", "0110"}), 1);
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0], (std::vector<glm::ivec2>{{1, 1}, {3, 1}, {3, 3}, {1, 3}}));
}

TEST(PlanSlice, AHoleIsALoopOfItsOwn) {
  const PlanSlice slice = drawn({"1111", "1#01", "1111"});
  EXPECT_EQ(traceOutline(slice, 1).size(), 2u);
  expectOutlinesAreTheSquares(slice, 1);
}

TEST(PlanSlice, OutlinesFilledAreTheSquaresOfAnyPicture) {
  std::mt19937 random(3);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> rows(9, std::string(13, '0'));
    for (std::string& row : rows) {
      for (char& c : row) c = static_cast<char>('0' + random() % 3);
    }
    for (CellGrid::Label label = 0; label < 3; ++label) {
      expectOutlinesAreTheSquares(drawn(rows), label);
    }
  }
}

TEST(PlanSlice, ALabelNobodyOwnsHasNoOutlineAndNoPlace) {
  EXPECT_TRUE(traceOutline(drawn({"00"}), 5).empty());
  EXPECT_EQ(placeLabel(drawn({"00"}), 5).squares, 0);
}

TEST(PlanSlice, ANameStandsWhereThereIsRoomForIt) {
  const LabelPlace place =
      placeLabel(drawn({"1#######", "1#111111", "11111111", "1#111111", "1#######"}), 1);
  EXPECT_EQ(place.squares, 5 + 6 + 7 + 6);
  EXPECT_FLOAT_EQ(place.center.y, 2.5f);
  EXPECT_FLOAT_EQ(place.center.x, 4);
  EXPECT_FLOAT_EQ(place.width, 8);
  EXPECT_FLOAT_EQ(place.height, 3);
}

TEST(PlanSlice, CutsTheGridAtItsHeightAndGivesPortalSquaresToASide) {
  // 4 × 2 × 1 voxels of 1 m: cell 1, a portal at x = 2, cell 2; above all is solid.
  CellGraph graph;
  graph.storeys.resize(1);
  graph.cells.resize(3);
  Portal portal;
  portal.polygon = {{1.6f, 0, 1}, {1.6f, 0, 0}, {1.6f, 1, 0}, {1.6f, 1, 1}};
  portal.plane = planeOf(portal.polygon);
  const bool front_is_left = portal.plane.signedDistance({0, 0.5f, 0.5f}) > 0;
  portal.front = front_is_left ? 1 : 2;
  portal.back = front_is_left ? 2 : 1;
  graph.portals.push_back(portal);
  linkCells(graph);
  const CellGrid::Label solid = CellGrid::kSolidVoxel, cut = CellGrid::kCutVoxel;
  const std::vector<CellGrid::Label> labels = {1, solid, cut, solid, 2, solid, 2, solid};
  const CellGrid grid({0, 0, 0}, 1, {4, 2, 1}, labels);
  using Labels = std::vector<CellGrid::Label>;
  EXPECT_EQ(sliceHouse(graph, grid, 0.5f).owner, (Labels{1, 1, 2, 2}));
  EXPECT_EQ(sliceHouse(graph, grid, 1.5f).owner, (Labels{solid, solid, solid, solid}));
  EXPECT_EQ(sliceHouse(graph, grid, 9.0f).owner, (Labels{0, 0, 0, 0}));
}

}  // namespace
}  // namespace enfilade
