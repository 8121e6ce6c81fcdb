#include "preprocess/share_geometry.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/preprocess/test_building.h"
#include "tests/preprocess/two_room_proposal.h"

namespace enfilade {
namespace {

// Left room, right room, a doorway between them with a portal, furniture in each, a slab under
// both.
struct Scene {
  TestBuilding test;
  VoxelGrid voxels;
  CutCells cells;
  std::uint32_t left_box, right_box, buried_box;

  Scene() {
    test.twoRooms({{1.5f, 2.5f, 0, 2.1f}});
    left_box = add({1, 0.5f, 1}, {1.5f, 1, 1.5f});
    right_box = add({6, 0.5f, 1}, {6.5f, 1, 1.5f});
    buried_box = add({3.97f, 2.5f, 1.0f}, {4.03f, 2.6f, 1.1f});
    voxels = voxelise(test.building, test.roles, 0.1f);
    CellProposal proposal = twoRoomProposal(voxels, "left", "right");
    Portal door;
    door.name = "door";
    door.polygon = {{4, 0, 1.5f}, {4, 0, 2.5f}, {4, 2.1f, 2.5f}, {4, 2.1f, 1.5f}};
    proposal.portals = {door};
    cells = cutCells(voxels, proposal);
  }
  std::uint32_t add(const glm::vec3& lo, const glm::vec3& hi) {
    test.box(lo, hi);
    return static_cast<std::uint32_t>(test.building.objects.size() - 1);
  }
};

std::vector<CellId> cellsOf(const PatchCells& claims, std::uint32_t patch) {
  std::vector<CellId> cells;
  for (const auto& claim : claims.claims)
    if (claim.patch == patch) cells.push_back(claim.cell);
  return cells;
}

TEST(Patches, APieceOfFurnitureStaysWholeAndALargeOneDoesNot) {
  TestBuilding test;
  test.box({0, 0, 0}, {0.5f, 0.5f, 0.5f});
  test.box({0, 0, 0}, {5, 0.2f, 5});
  const Patches patches = makePatches(test.building);
  EXPECT_EQ(patches.count, 1u + 12u);
  for (const std::uint32_t patch : patches.patch_of_triangle[0]) EXPECT_EQ(patch, 0u);
}

TEST(ClaimByTouch, FurnitureBelongsToItsRoomAndWhatIsInAWallIsNotLost) {
  Scene scene;
  const Patches patches = makePatches(scene.test.building);
  const PatchCells claims = claimByTouch(scene.test.building, patches, scene.voxels, scene.cells);
  const auto patchOf = [&](std::uint32_t object) { return patches.patch_of_triangle[object][0]; };
  EXPECT_EQ(cellsOf(claims, patchOf(scene.left_box)), std::vector<CellId>{1});
  EXPECT_EQ(cellsOf(claims, patchOf(scene.right_box)), std::vector<CellId>{2});
  EXPECT_FALSE(cellsOf(claims, patchOf(scene.buried_box)).empty());
  for (std::uint32_t p = 0; p < patches.count; ++p) EXPECT_FALSE(cellsOf(claims, p).empty());
}

TEST(ClaimBySight, WhatIsSeenThroughACrackIsClaimedByTheCellOfTheEye) {
  Scene scene;
  // A slit in the wall between the rooms, too thin for the voxels, with the right room's box behind
  // it.
  Building& b = scene.test.building;
  TestBuilding slit;
  slit.wall(false, 4, 0, 4, 0, 3, {{0.5f, 1.3f, 0.72f, 0.78f}, {1.5f, 2.5f, 0, 2.1f}});
  // The wall's three pieces around the doorway give way to the wall with the slit.
  std::vector<Object> kept;
  for (const Object& object : b.objects) {
    const Box box = worldBounds(b, object);
    if (box.min.x > 3.8f && box.max.x < 4.2f && box.size().y > 0.2f) continue;
    kept.push_back(object);
  }
  b.objects = kept;
  const auto base = static_cast<std::uint32_t>(b.vertex_arrays.size());
  for (std::size_t m = 0; m < slit.building.meshes.size(); ++m) {
    Mesh mesh = slit.building.meshes[m];
    mesh.vertices += base;
    b.nodes.push_back({});
    b.objects.push_back({static_cast<std::uint32_t>(b.nodes.size() - 1),
                         static_cast<std::uint32_t>(b.meshes.size())});
    b.meshes.push_back(mesh);
    b.vertex_arrays.push_back(slit.building.vertex_arrays[m]);
  }
  scene.test.roles.assign(b.objects.size(), ObjectRole::kFixed);
  std::uint32_t right = kNone;
  for (std::uint32_t o = 0; o < b.objects.size(); ++o)
    if (b.objects[o].node == scene.right_box) right = o;
  ASSERT_NE(right, kNone);

  const Patches patches = makePatches(b);
  PatchCells claims = claimByTouch(b, patches, scene.voxels, scene.cells);
  const std::uint32_t patch = patches.patch_of_triangle[right][0];
  ASSERT_EQ(cellsOf(claims, patch), std::vector<CellId>{2});
  claimBySight(b, scene.test.roles, patches, scene.cells, 400000, 1, {}, claims);
  EXPECT_EQ(cellsOf(claims, patch), (std::vector<CellId>{1, 2}));
}

TEST(ClaimBySight, TheSameClaimsForAnyNumberOfThreads) {
  Scene scene;
  const Patches patches = makePatches(scene.test.building);
  PatchCells one, two;
  claimBySight(scene.test.building, scene.test.roles, patches, scene.cells, 20000, 1, {}, one);
  claimBySight(scene.test.building, scene.test.roles, patches, scene.cells, 20000, 2, {}, two);
  EXPECT_FALSE(one.claims.empty());
  EXPECT_EQ(one.claims, two.claims);
}

TEST(SplitByCells, KeepsEveryTriangleOnceInOrderAndSharesWholeMeshes) {
  Scene scene;
  Building& b = scene.test.building;
  b.objects.push_back({scene.left_box, b.objects[scene.left_box].mesh});
  scene.test.roles.push_back(ObjectRole::kDoor);
  const Patches patches = makePatches(b);
  const PatchCells claims = claimByTouch(b, patches, scene.voxels, scene.cells);
  const SharedGeometry shared = splitByCells(b, scene.test.roles, patches, claims);
  EXPECT_EQ(triangleCount(shared.building), triangleCount(b));
  ASSERT_EQ(shared.cells.size(), shared.building.objects.size());
  ASSERT_EQ(shared.roles.size(), shared.building.objects.size());
  EXPECT_EQ(shared.roles.back(), ObjectRole::kDoor);
  std::map<std::uint32_t, int> uses;
  for (const Object& object : shared.building.objects) ++uses[object.mesh];
  EXPECT_EQ(uses[shared.building.objects.back().mesh], 2) << "a mesh placed twice stays shared";
  for (const auto& cells : shared.cells) EXPECT_FALSE(cells.empty());
}

}  // namespace
}  // namespace enfilade
