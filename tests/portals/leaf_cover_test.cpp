#include "portals/leaf_cover.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/preprocess/test_building.h"

namespace enfilade {
namespace {

/// A doorway of 1.0 x 2.0 m in the plane z = 0 and what its door is made of.
House houseWith(TestBuilding test) {
  House house;
  house.building = std::move(test.building);
  house.object_roles = std::move(test.roles);
  house.graph.cells.resize(2);
  Portal portal;
  portal.polygon = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}};
  portal.plane = planeOf(portal.polygon);
  portal.front = 1;
  portal.back = kExterior;
  house.graph.portals = {portal};
  return house;
}

float seenWithin(const TestBuilding& test) {
  const House house = houseWith(test);
  return seenWithinWhenShut(house, 0, doorLeaves(house));
}

TEST(LeafCover, AFullLeafIsSeenThroughFromBetweenItAndThePortalOnly) {
  TestBuilding test;
  test.box({0, 0, 0.1f}, {1, 2, 0.14f}, ObjectRole::kDoor);
  EXPECT_FLOAT_EQ(seenWithin(test), 0.14f);
}

TEST(LeafCover, SlitsOfHalfACentimetreAreNotLookedThrough) {
  TestBuilding test;
  test.box({0.005f, 0.006f, 0}, {0.498f, 1.996f, 0.04f}, ObjectRole::kDoor);
  test.box({0.502f, 0.006f, 0}, {0.995f, 1.996f, 0.04f}, ObjectRole::kDoor);
  EXPECT_FLOAT_EQ(seenWithin(test), 0.04f);
}

TEST(LeafCover, AGapUnderTheLeafIs) {
  TestBuilding test;
  test.box({0, 0.05f, 0}, {1, 2, 0.04f}, ObjectRole::kDoor);
  EXPECT_TRUE(std::isinf(seenWithin(test)));
}

TEST(LeafCover, GlassIs) {
  TestBuilding test;
  test.box({0, 0, 0}, {1, 2, 0.04f}, ObjectRole::kDoor, true);
  EXPECT_TRUE(std::isinf(seenWithin(test)));
  test.box({0, 0, 0.01f}, {1, 2, 0.02f}, ObjectRole::kDoor);
  EXPECT_FALSE(std::isinf(seenWithin(test))) << "not with a board behind it";
}

TEST(LeafCover, ASheetHidesFromTheSideThatItIsSeenFrom) {
  for (const bool double_sided : {false, true}) {
    TestBuilding test;
    test.box({0, 0, 0}, {1, 2, 0.04f}, ObjectRole::kDoor);
    Mesh& mesh = test.building.meshes[0];
    std::vector<std::uint32_t> facing;  // the box's face at its greatest z
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      const auto& positions = test.building.vertex_arrays[mesh.vertices].positions;
      bool at_front = true;
      for (std::size_t k = 0; k < 3; ++k) at_front &= positions[mesh.indices[i + k]].z > 0.03f;
      if (!at_front) continue;
      facing.insert(facing.end(), {mesh.indices[i], mesh.indices[i + 1], mesh.indices[i + 2]});
    }
    mesh.indices = facing;
    test.building.materials[0].double_sided = double_sided;
    EXPECT_EQ(std::isinf(seenWithin(test)), !double_sided);
  }
}

TEST(LeafCover, WithoutALeafNothingIsSeenThroughAShutPortal) {
  TestBuilding test;
  test.box({0, 0, 0}, {1, 2, 0.04f});  // no door
  EXPECT_EQ(seenWithin(test), 0);
}

TEST(LeafCover, IsOfShutPortalsOnly) {
  TestBuilding test;
  test.box({0, 0, 0}, {1, 2, 0.04f}, ObjectRole::kDoor, true);
  House house = houseWith(test);
  lookThroughShutPortals(house, doorLeaves(house));
  EXPECT_EQ(house.graph.portals[0].seen_within, 0);
  house.graph.portals[0].active = false;
  lookThroughShutPortals(house, doorLeaves(house));
  EXPECT_TRUE(std::isinf(house.graph.portals[0].seen_within));
}

}  // namespace
}  // namespace enfilade
