#include "preprocess/crack_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "preprocess/patch_views.h"
#include "preprocess/random_sphere.h"
#include "tests/preprocess/test_building.h"
#include "tests/preprocess/two_room_proposal.h"

namespace enfilade {
namespace {

/// Rooms "left" and "right" of 4 × 3 × 4 m, parted by a wall at x = 4 whose only opening is a slit,
/// 6 cm high and so too thin for the voxels; small boxes about the right room.
struct SlitRooms {
  TestBuilding test;
  VoxelGrid voxels;
  CutCells cells;
  Patches patches;
  std::vector<std::uint32_t> boxes;  ///< objects

  SlitRooms() {
    test.twoRooms({{1.0f, 1.8f, 1.02f, 1.08f}});
    std::mt19937 random(3);
    for (int i = 0; i < 60; ++i) {
      const glm::vec3 at =
          glm::vec3(6, 1.5f, 2) + glm::vec3(1.6f, 1.3f, 1.6f) * randomInCube(random);
      boxes.push_back(static_cast<std::uint32_t>(test.building.objects.size()));
      test.box(at - 0.06f, at + 0.06f);
    }
    voxels = voxelise(test.building, test.roles, 0.1f);
    const CellProposal proposal = twoRoomProposal(voxels, "left", "right");
    cells = cutCells(voxels, proposal);
    patches = makePatches(test.building);
  }

  std::uint32_t patchOf(std::uint32_t object) const { return patches.patch_of_triangle[object][0]; }

  /// How many of 40 lines from the left room through the slit to the box meet nothing on the way.
  int timesSeenFromLeft(std::uint32_t object, const RayCaster& rays) const {
    const Box box = worldBounds(test.building, test.building.objects[object]);
    std::mt19937 random(object);
    int seen_times = 0;
    for (int i = 0; i < 40; ++i) {
      const glm::vec3 target = box.center() + 0.5f * box.size() * randomInCube(random);
      const glm::vec3 slit =
          glm::vec3(4, 1.05f, 1.4f) + glm::vec3(0.1f, 0.03f, 0.4f) * randomInCube(random);
      const glm::vec3 direction = glm::normalize(slit - target);
      const glm::vec3 origin = target + direction * ((target.x - 3.5f) / -direction.x);
      if (origin.x > 3.6f || !Box{{0, 0.1f, 0.2f}, {4, 2.9f, 3.8f}}.contains(origin)) continue;
      const RayHit seen = rays.cast(origin, -direction, 0, 100, false);
      seen_times += seen.distance >= 0 && seen.object == object;
    }
    return seen_times;
  }
};

TEST(CrackSearch, ClaimsAllThatIsSeenThroughASlitOfWhichFewLinesFindAnything) {
  const SlitRooms rooms;
  const RayCaster rays(rooms.test.building, {}, 1);
  PatchCells claims = claimByTouch(rooms.test.building, rooms.patches, rooms.voxels, rooms.cells);
  const auto isClaimed = [&](std::uint32_t object) {
    const PatchCells::Claim claim{rooms.patchOf(object), 1};
    return std::binary_search(claims.claims.begin(), claims.claims.end(), claim);
  };
  for (const std::uint32_t box : rooms.boxes) ASSERT_FALSE(isClaimed(box));
  claimBySight(rooms.test.building, rooms.test.roles, rooms.patches, rooms.cells, 4000, 1, {},
               claims);
  int seen = 0;
  for (const std::uint32_t box : rooms.boxes) {
    if (rooms.timesSeenFromLeft(box, rays) < 4) continue;
    ++seen;
    EXPECT_TRUE(isClaimed(box)) << box;
  }
  EXPECT_GE(seen, 10);
}

TEST(CrackSearch, LinesLeaveTheirCellWithinWhatTheVoxelsCallSolid) {
  const SlitRooms rooms;
  const RayCaster rays(rooms.test.building, {}, 1);
  const PortalWalker walker(rooms.cells.graph);
  const SightClaims sight(rooms.test.building, rays, walker, rooms.patches, rooms.cells);
  Sighted found;
  std::mt19937 random(1);
  for (int i = 0; i < 20000; ++i) {  // by way of the slit
    const glm::vec3 from = glm::vec3(2, 1.05f, 1.4f) + randomInCube(random);
    const glm::vec3 to = glm::vec3(4, 1.05f, 1.4f) + 0.03f * randomInCube(random);
    if (sight.labelAt(from) == 1) sight.follow(1, from, glm::normalize(to - from), found);
  }
  ASSERT_FALSE(found.cracks.empty());
  int through = 0;
  for (const CrackLine& line : found.cracks) {
    EXPECT_EQ(line.claim.cell, 1u);
    if (line.end.x < 4.2f) continue;  // ended in the slit
    ++through;
    const float length = glm::distance(line.start, line.end);
    const glm::vec3 direction = (line.end - line.start) / length;
    EXPECT_LT(line.solid_from, line.solid_to);
    EXPECT_LE(line.solid_to, length + 1e-4f);
    EXPECT_EQ(sight.labelAt(line.start + direction * line.solid_from), 1);
    // The wall's middle plane lies between.
    EXPECT_LT((line.start + direction * line.solid_from).x, 4);
    EXPECT_GT((line.start + direction * line.solid_to).x, 4);
  }
  EXPECT_GT(through, 0);
}

TEST(CrackSearch, PatchesLookOutOfTheSlitIntoBothRooms) {
  const SlitRooms rooms;
  const RayCaster rays(rooms.test.building, {}, 1);
  const PortalWalker walker(rooms.cells.graph);
  const SightClaims sight(rooms.test.building, rays, walker, rooms.patches, rooms.cells);
  const auto lines = lookFromPatches(rooms.test.building, rooms.patches, rays, sight, 100000);
  std::array<int, 3> from{};
  for (const CrackLine& line : lines) {
    ASSERT_LT(line.claim.cell, 3u);
    ++from[line.claim.cell];
    EXPECT_EQ(sight.labelAt(line.start), line.claim.cell);
    const float length = glm::distance(line.start, line.end);
    const RayHit hit = rays.cast(line.start, (line.end - line.start) / length, 0, 100, false);
    ASSERT_GE(hit.distance, 0);
    EXPECT_GT(hit.distance, length - 1e-3f);  // nothing before the patch
  }
  EXPECT_GT(from[1], 0);
  EXPECT_GT(from[2], 0);
}

}  // namespace
}  // namespace enfilade
