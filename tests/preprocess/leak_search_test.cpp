#include "preprocess/leak_search.h"

#include <gtest/gtest.h>

#include "preprocess/cut_cells.h"
#include "tests/preprocess/test_building.h"
#include "tests/preprocess/two_room_proposal.h"

namespace enfilade {
namespace {

TEST(LeakSearch, IsFoundInTheHoleBetweenTwoRooms) {
  TestBuilding test;
  test.twoRooms({{1.0f, 1.4f, 2.0f, 2.4f}});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const CellProposal proposal = twoRoomProposal(voxels, "west", "east");
  const std::vector<std::uint8_t> uncut(voxels.bits.size(), 0);
  const auto leak = LeakSearch(voxels, uncut, proposal.owner).find(1, 2);
  ASSERT_TRUE(leak.has_value());
  EXPECT_NEAR(leak->place.x, 4.0f, 0.2f);
  EXPECT_NEAR(leak->place.y, 2.2f, 0.25f);
  EXPECT_NEAR(leak->place.z, 1.2f, 0.25f);
}

TEST(LeakSearch, OfARoomIntoTheOutsideIsToldWithItsPlace) {
  TestBuilding test;
  test.twoRooms({}, {{1.0f, 1.6f, 0.5f, 1.1f}});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  CellProposal proposal = twoRoomProposal(voxels, "west", "east");
  // The exterior's own, beyond the hole.
  for (std::size_t i = 0; i < proposal.owner.size(); ++i) {
    if (proposal.owner[i] == CellProposal::kNobody && !(voxels.bits[i] & kVoxelSolid)) {
      proposal.owner[i] = kExterior;
    }
  }
  const CutCells cells = cutCells(voxels, proposal);
  ASSERT_EQ(cells.log.size(), 1u);
  EXPECT_EQ(cells.log[0].rfind("LEAK: merged east into exterior", 0), 0u) << cells.log[0];
  EXPECT_NE(cells.log[0].find("through (8."), std::string::npos) << cells.log[0];
  ASSERT_EQ(cells.leaks.size(), 1u);
  EXPECT_EQ(cells.leaks[0].room, "east");
  EXPECT_EQ(cells.leaks[0].into, "exterior");
  EXPECT_LT(cells.leaks[0].path.front().x, 8.0f);
  EXPECT_GT(cells.leaks[0].path.back().x, 8.2f);
}

TEST(LeakSearch, PathRunsThroughFreeSpaceFromTheMiddleOfTheRoom) {
  TestBuilding test;
  test.twoRooms({{0.4f, 0.8f, 2.0f, 2.4f}});
  test.box({2.8f, 0, 0}, {3.0f, 3, 2.5f});  // a screen before the hole, which the path goes about
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const CellProposal proposal = twoRoomProposal(voxels, "west", "east");
  const std::vector<std::uint8_t> uncut(voxels.bits.size(), 0);
  const auto leak = LeakSearch(voxels, uncut, proposal.owner).find(1, 2);
  ASSERT_TRUE(leak.has_value());
  ASSERT_GE(leak->path.size(), 3u);
  EXPECT_LE(leak->path.size(), 8u) << "straight parts, not a step a voxel";
  EXPECT_LT(glm::distance(leak->path.front(), glm::vec3(2.0f, 1.5f, 2.0f)), 0.8f);
  EXPECT_GT(leak->path.back().x, 4.5f);
  for (std::size_t i = 0; i + 1 < leak->path.size(); ++i) {
    for (int step = 0; step <= 200; ++step) {
      const glm::vec3 p =
          glm::mix(leak->path[i], leak->path[i + 1], static_cast<float>(step) / 200.0f);
      bool free = false;  // there or a centimetre beside, since corners may be cut by that much
      for (const float aside : {0.0f, -0.01f, 0.01f}) {
        const glm::ivec3 v = voxels.voxelOf(p + glm::vec3(aside, 0, 0));
        free |= (voxels.bits[voxels.index(v.x, v.y, v.z)] & kVoxelSolid) == 0;
      }
      EXPECT_TRUE(free) << p.x << " " << p.y << " " << p.z;
    }
  }
}

TEST(LeakSearch, RoomsThatBecomeOneAreNoLeak) {
  TestBuilding test;
  test.twoRooms({{1.0f, 1.6f, 0.5f, 1.1f}});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const CutCells cells = cutCells(voxels, twoRoomProposal(voxels, "west", "east"));
  ASSERT_EQ(cells.log.size(), 1u);
  EXPECT_EQ(cells.log[0].rfind("merged east into west", 0), 0u) << cells.log[0];
  EXPECT_TRUE(cells.leaks.empty());
}

TEST(LeakSearch, ThereIsNoneBetweenClosedRooms) {
  TestBuilding test;
  test.twoRooms({});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const std::vector<std::uint8_t> uncut(voxels.bits.size(), 0);
  const CellProposal proposal = twoRoomProposal(voxels, "west", "east");
  EXPECT_FALSE(LeakSearch(voxels, uncut, proposal.owner).find(1, 2).has_value());
}

}  // namespace
}  // namespace enfilade
