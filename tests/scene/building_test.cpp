#include "scene/building.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace enfilade {
namespace {

/// A triangle in the corner of the unit cube, placed twice: as it is, and turned by 45° about y
/// below a node named "Door".  A fourth vertex lies far away and is not indexed.
Building twoTriangles() {
  Building building;
  building.vertex_arrays.push_back({{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {99, 99, 99}}, {}, {}, {}});
  building.materials.push_back({.name = "Oak"});
  building.meshes.push_back({.name = "leaf", .vertices = 0, .indices = {0, 1, 2}});
  building.nodes.push_back({.name = "IfcWall/North"});
  building.nodes.push_back({.name = "IfcDoor/Front [1]"});
  building.nodes.push_back(
      {.name = "leaf",
       .parent = 1,
       .world_from_node = glm::rotate(glm::mat4(1), glm::radians(45.0f), glm::vec3(0, 1, 0))});
  building.objects = {{0, 0}, {2, 0}};
  return building;
}

TEST(WorldBounds, AreOfTheTurnedVerticesNotOfTheTurnedBox) {
  const Building building = twoTriangles();
  const Box box = worldBounds(building, building.objects[1]);
  const float h = std::sqrt(0.5f);
  EXPECT_NEAR(box.min.x, 0.0f, 1e-6f);
  EXPECT_NEAR(box.max.x, h, 1e-6f);
  EXPECT_NEAR(box.min.z, -h, 1e-6f);
  EXPECT_NEAR(box.max.z, h, 1e-6f);
}

TEST(WorldBounds, OfTheBuildingHoldAllObjectsAndNothingThatIsNotDrawn) {
  const Box box = worldBounds(twoTriangles());
  EXPECT_EQ(box.max.y, 1.0f);
  EXPECT_EQ(box.max.x, 1.0f);
  EXPECT_NEAR(box.min.z, -std::sqrt(0.5f), 1e-6f);
  EXPECT_TRUE(worldBounds(Building{}).empty());
}

TEST(TriangleCount, CountsASharedMeshOnceForEachObject) {
  EXPECT_EQ(triangleCount(twoTriangles()), 2u);
  EXPECT_EQ(triangleCount(Building{}), 0u);
}

using Flags = std::vector<std::uint8_t>;  // of a wall and a door

TEST(MatchNames, LooksAtTheNodeItsAncestorsAndTheMaterial) {
  const Building building = twoTriangles();
  EXPECT_EQ(matchNames(building, "leaf"), (Flags{0, 1}));
  EXPECT_EQ(matchNames(building, "IfcDoor*"), (Flags{0, 1}));
  EXPECT_EQ(matchNames(building, "O?k")[0], 1);
}

TEST(MatchNames, TakesSeveralPatternsAndMindsCase) {
  const Building building = twoTriangles();
  EXPECT_EQ(matchNames(building, "IfcWindow*,IfcDoor*"), (Flags{0, 1}));
  for (const char* none : {"ifcdoor*", "IfcDoor", "", ","}) {
    EXPECT_EQ(matchNames(building, none), (Flags{0, 0})) << none;
  }
}

TEST(IsMirrored, TellsAReflectionFromARotation) {
  EXPECT_FALSE(isMirrored(glm::mat4(1)));
  EXPECT_FALSE(isMirrored(twoTriangles().nodes[2].world_from_node));
  EXPECT_TRUE(isMirrored(glm::scale(glm::mat4(1), glm::vec3(1, 1, -1))));
  EXPECT_FALSE(isMirrored(glm::scale(glm::mat4(1), glm::vec3(-2, 1, -1))));
}

TEST(Box, GrowsOverlapsAndContains) {
  Box box;
  EXPECT_TRUE(box.empty());
  EXPECT_FALSE(box.contains({0, 0, 0}));
  box.extend(glm::vec3(0, 0, 0));
  box.extend(glm::vec3(2, 4, 6));
  EXPECT_EQ(box.center(), glm::vec3(1, 2, 3));
  EXPECT_TRUE(box.contains({2, 4, 6}));
  EXPECT_FALSE(box.overlaps({{2.5f, 0, 0}, {3, 1, 1}}));
  EXPECT_TRUE(box.grown(0.5f).overlaps({{2.5f, 0, 0}, {3, 1, 1}}));
}

TEST(Plane, IsPositiveOnTheSideOfItsNormal) {
  const Plane plane{{0, 1, 0}, -2};
  EXPECT_EQ(plane.signedDistance({7, 5, 0}), 3.0f);
  EXPECT_EQ(plane.signedDistance({7, 0, 0}), -2.0f);
}

}  // namespace
}  // namespace enfilade
