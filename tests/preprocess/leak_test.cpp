#include "preprocess/leak.h"

#include <gtest/gtest.h>

#include "preprocess/cut_cells.h"
#include "tests/preprocess/test_building.h"
#include "tests/preprocess/two_room_proposal.h"

namespace enfilade {
namespace {

TEST(Leak, IsFoundInTheHoleBetweenTwoRooms) {
  TestBuilding test;
  test.twoRooms({{1.0f, 1.4f, 2.0f, 2.4f}});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const CellProposal proposal = twoRoomProposal(voxels, "west", "east");
  const std::vector<std::uint8_t> uncut(voxels.bits.size(), 0);
  const auto leak = findLeak(voxels, uncut, proposal.owner, 1, 2);
  ASSERT_TRUE(leak.has_value());
  EXPECT_NEAR(leak->x, 4.0f, 0.2f);
  EXPECT_NEAR(leak->y, 2.2f, 0.25f);
  EXPECT_NEAR(leak->z, 1.2f, 0.25f);
}

TEST(Leak, OfARoomIntoTheOutsideIsToldWithItsPlace) {
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
}

TEST(Leak, ThereIsNoneBetweenClosedRooms) {
  TestBuilding test;
  test.twoRooms({});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const std::vector<std::uint8_t> uncut(voxels.bits.size(), 0);
  EXPECT_FALSE(
      findLeak(voxels, uncut, twoRoomProposal(voxels, "west", "east").owner, 1, 2).has_value());
}

}  // namespace
}  // namespace enfilade
