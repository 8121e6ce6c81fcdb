#include "preprocess/cut_cells.h"

#include <gtest/gtest.h>

#include "tests/preprocess/test_building.h"

namespace enfilade {
namespace {

// Two rooms side by side along x, 4 × 3 × 4 m each, parted by a wall at x = 4 with a doorway.
struct TwoRooms {
  TestBuilding test;
  VoxelGrid voxels;
  CellProposal proposal;

  explicit TwoRooms(float door_width = 1.0f) : TwoRooms(withDoorway(door_width)) {}
  explicit TwoRooms(TestBuilding building) : test(std::move(building)) {
    voxels = voxelise(test.building, test.roles, 0.1f);
    proposal.storeys = {{"ground", 0}};
    proposal.cell_names = {"exterior", "left", "right"};
    proposal.cell_storeys = {0, 0, 0};
    proposal.owner.assign(voxels.bits.size(), CellProposal::kNobody);
    own(1, {{0.1f, 0, 0.1f}, {4, 3, 3.9f}});
    own(2, {{4, 0, 0.1f}, {7.9f, 3, 3.9f}});
  }
  static TestBuilding withDoorway(float width) {
    TestBuilding building;
    building.twoRooms({{1.5f, 1.5f + width, 0, 2.1f}});
    return building;
  }
  void own(std::uint16_t cell, const Box& box) {
    for (int x = 0; x < voxels.size.x; ++x)
      for (int z = 0; z < voxels.size.z; ++z)
        for (int y = 0; y < voxels.size.y; ++y)
          if (box.contains(voxels.centerOf({x, y, z})))
            proposal.owner[voxels.index(x, y, z)] = cell;
  }
  void addDoor(float from = 1.5f, float to = 2.5f, float top = 2.1f) {
    Portal door;
    door.name = "door";
    door.polygon = {{4, 0, from}, {4, 0, to}, {4, top, to}, {4, top, from}};
    proposal.portals.push_back(door);
  }
};

TEST(CutCells, ADoorwayPortalPartsTwoRooms) {
  TwoRooms rooms;
  rooms.addDoor();
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  ASSERT_EQ(cut.graph.cells.size(), 3u);
  ASSERT_EQ(cut.graph.portals.size(), 1u);
  const Portal& door = cut.graph.portals[0];
  // The polygon's normal, z × y, points to −x.
  EXPECT_EQ(cut.graph.cells[door.front].name, "left");
  EXPECT_EQ(cut.graph.cells[door.back].name, "right");
  EXPECT_GT(door.plane.signedDistance({1, 1, 2}), 0);
  EXPECT_EQ(locate(cut.graph, cut.grid, {1, 1.6f, 2}).cell, door.front);
  EXPECT_EQ(locate(cut.graph, cut.grid, {7, 1.6f, 2}).cell, door.back);
  EXPECT_EQ(locate(cut.graph, cut.grid, {-3, 1.6f, 2}).cell, kExterior);
  EXPECT_TRUE(diagnose(cut.graph).empty());
}

TEST(CutCells, WindingOfThePolygonDoesNotMatter) {
  TwoRooms rooms;
  rooms.addDoor();
  auto& polygon = rooms.proposal.portals[0].polygon;
  std::reverse(polygon.begin(), polygon.end());
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  ASSERT_EQ(cut.graph.portals.size(), 1u);
  const Portal& door = cut.graph.portals[0];
  EXPECT_EQ(cut.graph.cells[door.front].name, "right");
  EXPECT_TRUE(diagnose(cut.graph).empty());
}

TEST(CutCells, RoomsWithoutAPortalBetweenThemBecomeOne) {
  TwoRooms rooms;
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  ASSERT_EQ(cut.graph.cells.size(), 2u);
  EXPECT_EQ(cut.graph.cells[1].name, "left");
  EXPECT_NEAR(cut.graph.cells[1].volume, 2 * 3.8 * 3.8 * 3, 8);
  ASSERT_EQ(cut.log.size(), 1u);
  EXPECT_NE(cut.log[0].find("merged right into left"), std::string::npos) << cut.log[0];
}

TEST(CutCells, APortalThatDoesNotCloseItsDoorwayGoesAndTheRoomsMerge) {
  TwoRooms rooms(2.0f);
  rooms.addDoor(1.5f, 2.5f);  // half the doorway stays open
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  EXPECT_EQ(cut.graph.cells.size(), 2u);
  EXPECT_TRUE(cut.graph.portals.empty());
  // No voxel stays cut: the camera must find its cell there too.
  EXPECT_EQ(std::count(cut.labels.begin(), cut.labels.end(), CellGrid::kCutVoxel), 0);
}

TEST(CutCells, APortalInTheMiddleOfARoomIsDropped) {
  TwoRooms rooms;
  rooms.addDoor();
  Portal screen;
  screen.name = "screen";
  screen.polygon = {{2, 0, 1}, {2, 0, 2}, {2, 2, 2}, {2, 2, 1}};
  rooms.proposal.portals.push_back(screen);
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  EXPECT_EQ(cut.graph.cells.size(), 3u);
  ASSERT_EQ(cut.graph.portals.size(), 1u);
  EXPECT_EQ(cut.graph.portals[0].name, "door");
}

TEST(CutCells, APortalBeforeTwoRoomsStandsForEachUnderANameOfItsOwn) {
  TestBuilding test;
  test.twoRooms({{1.5f, 2.5f, 0, 2.1f}});
  test.wall(true, 2, 4, 8, 0, 3, {}, 0.1f);  // meets the doorway in its middle
  TwoRooms rooms(test);
  rooms.proposal.cell_names.push_back("right too");
  rooms.proposal.cell_storeys.push_back(0);
  rooms.own(3, {{4.1f, 0, 2.1f}, {8, 3, 4}});
  rooms.addDoor();
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  ASSERT_EQ(cut.graph.portals.size(), 2u);
  EXPECT_EQ(cut.graph.portals[0].name, "door");
  EXPECT_EQ(cut.graph.portals[1].name, "door#2");
  EXPECT_EQ(cut.graph.portals[0].polygon, cut.graph.portals[1].polygon);
}

TEST(CutCells, SpaceThatNoOneProposedBehindAPortalIsACell) {
  TwoRooms rooms;
  rooms.addDoor();
  rooms.own(CellProposal::kNobody, {{4, 0, 0}, {8, 3, 4}});
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  ASSERT_EQ(cut.graph.cells.size(), 3u);
  EXPECT_EQ(cut.graph.cells[2].name, "cell-1");
  EXPECT_EQ(locate(cut.graph, cut.grid, {7, 1.6f, 2}).cell, 2u);
}

TEST(CutCells, ASealedCavityBelongsToNobody) {
  TwoRooms rooms;
  rooms.test.box({1, 0, 1}, {2, 1, 2});  // hollow: a box of faces alone
  rooms.voxels = voxelise(rooms.test.building, rooms.test.roles, 0.1f);
  const std::uint16_t left = 1;
  rooms.proposal.owner.assign(rooms.voxels.bits.size(), CellProposal::kNobody);
  rooms.own(left, {{0.1f, 1.2f, 0.1f}, {3.9f, 3, 3.9f}});
  rooms.addDoor();
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  EXPECT_EQ(cut.grid.labelAt(cut.grid.voxelOf({1.5f, 0.5f, 1.5f})), CellGrid::kSolidVoxel);
  EXPECT_EQ(cut.graph.cells.size(), 3u);
}

TEST(CutCells, NoTwoNeighbouringVoxelsBelongToTwoCells) {
  TwoRooms rooms;
  rooms.addDoor();
  const CutCells cut = cutCells(rooms.voxels, rooms.proposal);
  const auto isCell = [](CellGrid::Label label) { return label < CellGrid::kCutVoxel; };
  for (int x = 1; x < rooms.voxels.size.x; ++x) {
    for (int z = 1; z < rooms.voxels.size.z; ++z) {
      for (int y = 1; y < rooms.voxels.size.y; ++y) {
        const auto here = cut.labels[rooms.voxels.index(x, y, z)];
        for (const auto& [dx, dy, dz] : {std::array{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) {
          const auto there = cut.labels[rooms.voxels.index(x - dx, y - dy, z - dz)];
          ASSERT_FALSE(isCell(here) && isCell(there) && here != there);
        }
      }
    }
  }
}

}  // namespace
}  // namespace enfilade
