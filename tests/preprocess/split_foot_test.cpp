#include "preprocess/split_foot.h"

#include <gtest/gtest.h>

namespace enfilade {
namespace {

/// Ten by twenty upright faces at x = 0 and, if asked for, ten level ones in the floor before it.
Interface doorway(bool gap) {
  Interface interface;
  interface.low = 0;
  interface.high = 1;
  interface.normal = glm::normalize(glm::vec3(1, gap ? -0.05f : 0.0f, 0));
  for (int z = 0; z < 10; ++z) {
    for (int y = 0; y < 20; ++y) {
      interface.faces.push_back({0, 0.05f + 0.1f * float(y), 0.05f + 0.1f * float(z)});
    }
    if (gap) interface.faces.push_back({0.05f, 0, 0.05f + 0.1f * float(z)});
  }
  for (const glm::vec3& face : interface.faces) {
    interface.bounds.extend(face);
    interface.centroid += face / float(interface.faces.size());
  }
  return interface;
}

VoxelGrid grid() {
  VoxelGrid voxels;
  voxels.origin = {-1, -1, -1};
  voxels.size = {30, 40, 30};
  return voxels;
}

TEST(SplitFoot, PartsTheDoorFromTheGapBeforeIt) {
  const auto parts = splitFoot(grid(), doorway(true));
  ASSERT_TRUE(parts.has_value());
  EXPECT_EQ(parts->first.faces.size(), 200u);
  EXPECT_NEAR(parts->first.foot, 0.0f, 1e-5f);
  EXPECT_FLOAT_EQ(parts->first.normal.y, 0.0f);
  EXPECT_EQ(parts->second.faces.size(), 10u);
  EXPECT_FLOAT_EQ(std::abs(parts->second.normal.y), 1.0f);
  EXPECT_EQ(parts->second.low, 0);
  EXPECT_EQ(parts->second.high, 1);
}

TEST(SplitFoot, LeavesADoorwayWithAWholeFloorAlone) {
  EXPECT_FALSE(splitFoot(grid(), doorway(false)).has_value());
}

}  // namespace
}  // namespace enfilade
