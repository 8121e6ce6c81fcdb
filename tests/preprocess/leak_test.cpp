#include "preprocess/leak.h"

#include <gtest/gtest.h>

#include "preprocess/cut_cells.h"
#include "test_building.h"

namespace enfilade {
namespace {

/// Two rooms, their voxels given to 1 and 2 by the wall at x = 4; outside nobody's.
CellProposal proposalFor(const VoxelGrid& voxels) {
  CellProposal proposal;
  proposal.storeys = {{"storey", 0}};
  proposal.cell_names = {"exterior", "west", "east"};
  proposal.cell_storeys = {0, 0, 0};
  proposal.owner.assign(voxels.bits.size(), CellProposal::kNobody);
  for (int x = 0; x < voxels.size.x; ++x)
    for (int z = 0; z < voxels.size.z; ++z)
      for (int y = 0; y < voxels.size.y; ++y) {
        const glm::vec3 p = voxels.centerOf({x, y, z});
        const bool inside = p.x > 0 && p.x < 8 && p.y > 0 && p.y < 3 && p.z > 0 && p.z < 4;
        const std::size_t i = voxels.index(x, y, z);
        if (voxels.bits[i] & kVoxelSolid) continue;
        if (inside) proposal.owner[i] = p.x < 4 ? 1 : 2;
      }
  return proposal;
}

TEST(Leak, IsFoundInTheHoleBetweenTwoRooms) {
  TestBuilding test;
  test.twoRooms({{1.0f, 1.4f, 2.0f, 2.4f}});
  const VoxelGrid voxels = voxelise(test.building, test.roles, 0.1f);
  const CellProposal proposal = proposalFor(voxels);
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
  CellProposal proposal = proposalFor(voxels);
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
  EXPECT_FALSE(findLeak(voxels, uncut, proposalFor(voxels).owner, 1, 2).has_value());
}

}  // namespace
}  // namespace enfilade
