#include "preprocess/voxel_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#define GLM_ENABLE_EXPERIMENTAL
#include <glm/gtx/component_wise.hpp>
#include <random>

#include "scene/error.h"
#include "test_building.h"

namespace enfilade {
namespace {

/// Clips the triangle by the six planes of the box, in double precision: whether anything is left.
bool touches(const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& lo,
             const glm::dvec3& hi) {
  std::vector<glm::dvec3> polygon(triangle.begin(), triangle.end());
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const auto inside = [&](const glm::dvec3& p) {
        return sign > 0 ? p[axis] - lo[axis] : hi[axis] - p[axis];
      };
      std::vector<glm::dvec3> kept;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = inside(a), db = inside(b);
        if (da >= 0) kept.push_back(a);
        if ((da < 0) != (db < 0)) kept.push_back(a + (b - a) * (da / (da - db)));
      }
      polygon = kept;
    }
  }
  return !polygon.empty();
}

TEST(Voxelise, MarksEveryVoxelThatATriangleTouchesAndFewOthers) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-1.0f, 1.0f);
  for (int trial = 0; trial < 200; ++trial) {
    TestBuilding test;
    std::array<glm::vec3, 3> c;
    for (auto& p : c) p = {place(random), place(random), place(random)};
    if (trial % 4 == 1) c[2] = c[0] * 0.5f + c[1] * 0.5f;  // a sliver without area
    if (trial % 4 == 2) c[1].y = c[2].y = c[0].y;          // level
    if (trial % 4 == 3) c[1].x = c[2].x = c[0].x;          // upright
    test.triangle(c[0], c[1], c[2]);
    const VoxelGrid grid = voxelise(test.building, test.roles, 0.13f);
    for (int x = 0; x < grid.size.x; ++x)
      for (int z = 0; z < grid.size.z; ++z)
        for (int y = 0; y < grid.size.y; ++y) {
          const glm::dvec3 lo = glm::dvec3(grid.origin) + glm::dvec3(x, y, z) * double(grid.voxel);
          const glm::dvec3 hi = lo + double(grid.voxel), slack(0.002 * grid.voxel);
          const std::array<glm::dvec3, 3> t{c[0], c[1], c[2]};
          const bool solid = grid.bits[grid.index(x, y, z)] & kVoxelSolid;
          ASSERT_TRUE(solid || !touches(t, lo, hi)) << "trial " << trial;
          ASSERT_TRUE(!solid || touches(t, lo - slack, hi + slack)) << "trial " << trial;
        }
  }
}

TEST(Voxelise, LeavesTheMarginFreeOnEverySide) {
  TestBuilding test;
  test.box({1, 2, 3}, {2, 4, 6});
  const VoxelGrid grid = voxelise(test.building, test.roles, 0.1f, 4);
  glm::ivec3 first = grid.size, last(-1);
  for (int x = 0; x < grid.size.x; ++x)
    for (int z = 0; z < grid.size.z; ++z)
      for (int y = 0; y < grid.size.y; ++y)
        if (grid.bits[grid.index(x, y, z)]) {
          first = glm::min(first, glm::ivec3(x, y, z));
          last = glm::max(last, glm::ivec3(x, y, z));
        }
  EXPECT_EQ(first, glm::ivec3(4));
  EXPECT_GE(glm::compMin(grid.size - 1 - last), 4);
  EXPECT_TRUE(grid.contains(grid.voxelOf({1, 2, 3})));
  EXPECT_EQ(grid.voxelOf(grid.centerOf(first)), first);
}

TEST(Voxelise, AFaceOnAGridLineDoesNotVanish) {
  for (const float at : {0.0f, 0.1f, 0.3f, 0.05f, 1.0f}) {
    TestBuilding test;
    test.box({-1, -1, -1}, {-0.9f, -0.9f, -0.9f});
    test.triangle({at, 0, 0}, {at, 1, 0}, {at, 0, 1});
    const VoxelGrid grid = voxelise(test.building, test.roles, 0.1f);
    EXPECT_TRUE(
        grid.bits[grid.index(grid.voxelOf({at, 0.2f, 0.2f}).x, grid.voxelOf({at, 0.2f, 0.2f}).y,
                             grid.voxelOf({at, 0.2f, 0.2f}).z)]);
  }
}

TEST(Voxelise, RolesAndBlendedMaterialGiveTheBits) {
  TestBuilding test;
  test.box({0, 0, 0}, {0.5f, 0.5f, 0.5f});
  test.box({2, 0, 0}, {2.5f, 0.5f, 0.5f}, ObjectRole::kDoor);
  test.box({4, 0, 0}, {4.5f, 0.5f, 0.5f}, ObjectRole::kGlass);
  test.box({6, 0, 0}, {6.5f, 0.5f, 0.5f}, ObjectRole::kFixed, true);
  test.box({8, 0, 0}, {8.5f, 0.5f, 0.5f}, ObjectRole::kDoor, true);
  const VoxelGrid grid = voxelise(test.building, test.roles, 0.1f);
  const auto at = [&](float x) {
    const glm::ivec3 v = grid.voxelOf({x, 0.25f, 0.0f});
    return grid.bits[grid.index(v.x, v.y, v.z)];
  };
  EXPECT_EQ(at(0.25f), kVoxelSolid);
  EXPECT_EQ(at(2.25f), kVoxelDoor);
  EXPECT_EQ(at(4.25f), kVoxelGlass);
  EXPECT_EQ(at(6.25f), kVoxelGlass);
  EXPECT_EQ(at(8.25f), kVoxelDoor);
}

TEST(Voxelise, NamesAVoxelSizeThatWouldFitABuildingTooLarge) {
  TestBuilding test;
  test.box({0, 0, 0}, {1, 1, 1});
  test.box({300, 50, 300}, {301, 51, 301});
  try {
    voxelise(test.building, test.roles, 0.1f);
    FAIL() << "no error";
  } catch (const Error& error) {
    const std::string what = error.what();
    const std::size_t at = what.find("voxels of ", what.find(';'));
    ASSERT_NE(at, std::string::npos) << what;
    const float enough = std::stof(what.substr(at + 10));
    EXPECT_GT(enough, 0.1f);
    EXPECT_LT(enough, 0.6f);
    EXPECT_NO_THROW(voxelise(test.building, test.roles, enough));
  }
}

TEST(Voxelise, AsksForTheUnitOfABuildingThatNoDoorWouldBeFoundIn) {
  TestBuilding test;
  test.box({0, 0, 0}, {1, 1, 1});
  test.box({100'000, 500, 3000}, {100'001, 501, 3001});
  try {
    voxelise(test.building, test.roles, 0.1f);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("are its lengths in metres"), std::string::npos)
        << error.what();
  }
}

TEST(Voxelise, RejectsABuildingWithoutTrianglesOrWithVerticesThatAreNoNumbers) {
  TestBuilding none;
  EXPECT_THROW(voxelise(none.building, none.roles, 0.1f), Error);
  TestBuilding test;
  test.box({0, 0, 0}, {1, std::numeric_limits<float>::infinity(), 1});
  EXPECT_THROW(voxelise(test.building, test.roles, 0.1f), Error);
  TestBuilding nan;
  nan.box({0, 0, 0}, {1, 1, 1});
  nan.triangle({0, 0, 0}, {1, std::numeric_limits<float>::quiet_NaN(), 0}, {0, 0, 1});
  EXPECT_THROW(voxelise(nan.building, nan.roles, 0.1f), Error);
}

}  // namespace
}  // namespace enfilade
