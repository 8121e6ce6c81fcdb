#include "visibility/eye_culling.h"

#include <gtest/gtest.h>

#include "room_row.h"
#include "scene/camera.h"

namespace enfilade {
namespace {

using namespace enfilade::testing;

constexpr float kVoxel = 0.1f;

/// Two rooms side by side along x, 2 × 2 × 2 m each, a wall of 0.2 m between them at x = 2.
class EyeCulling : public ::testing::Test {
 protected:
  EyeCulling() : graph_(graphOf(3, {})) {
    const glm::ivec3 size(42, 20, 20);
    std::vector<CellGrid::Label> labels(static_cast<std::size_t>(size.x * size.y * size.z));
    for (int x = 0; x < size.x; ++x) {
      const CellGrid::Label label = x < 20 ? 1 : x < 22 ? CellGrid::kSolidVoxel : 2;
      std::fill_n(labels.begin() + x * size.y * size.z, size.y * size.z, label);
    }
    grid_ = CellGrid(glm::vec3(0), kVoxel, size, labels);
  }

  Camera at(const glm::vec3& eye, const glm::vec3& target) const {
    Camera camera;
    camera.pose = lookAt(eye, target);
    camera.near_plane = 0.05f;
    return camera;
  }
  std::size_t cellsSeen(const Camera& camera) const {
    return cullFromEye(graph_, grid_, camera.view()).cells.size();
  }

  CellGraph graph_;
  CellGrid grid_;
};

TEST_F(EyeCulling, AnEyeInARoomSeesItsOwnCellAlone) {
  EXPECT_EQ(cellsSeen(at({1, 1, 1}, {3, 1, 1})), 1u);
  EXPECT_EQ(cellsSeen(at({3, 1, 1}, {1, 1, 1})), 1u);
}

TEST_F(EyeCulling, AnEyeInAWallSeesEveryCell) {
  const VisibleSet set = cullFromEye(graph_, grid_, at({2.12f, 1, 1}, {3, 1, 1}).view());
  EXPECT_EQ(set.cells.size(), graph_.cells.size());
  EXPECT_EQ(set.eye_cell, 2u);
  EXPECT_TRUE(set.portals.empty());
}

TEST_F(EyeCulling, ANearPlaneThatReachesIntoAWallSeesEveryCell) {
  const Camera before = at({1.97f, 1, 1}, {3, 1, 1});
  EXPECT_FALSE(nearPlaneIsInFreeSpace(grid_, before.view()));
  EXPECT_EQ(cellsSeen(before), graph_.cells.size());
}

TEST_F(EyeCulling, AnEyeJustBeforeAWallThatLooksAwaySeesItsOwnCellAlone) {
  const Camera away = at({1.97f, 1, 1}, {0, 1, 1});
  EXPECT_TRUE(nearPlaneIsInFreeSpace(grid_, away.view()));
  EXPECT_EQ(cellsSeen(away), 1u);
}

TEST_F(EyeCulling, AWideViewAlongAWallReachesIntoItSooner) {
  Camera along = at({1.9f, 1, 0.5f}, {1.9f, 1, 2});
  EXPECT_TRUE(nearPlaneIsInFreeSpace(grid_, along.view()));
  along.vertical_fov = glm::radians(170.0f);
  EXPECT_FALSE(nearPlaneIsInFreeSpace(grid_, along.view()));
}

TEST_F(EyeCulling, OutsideTheGridNothingIsCut) {
  EXPECT_TRUE(nearPlaneIsInFreeSpace(grid_, at({-5, 1, 1}, {3, 1, 1}).view()));
  Camera far_off = at({1e7f, 1e7f, 1e7f}, {0, 0, 0});
  EXPECT_EQ(cullFromEye(graph_, grid_, far_off.view()).eye_cell, kExterior);
}

TEST_F(EyeCulling, ANearPlaneLargerThanAnyVoxelCountsAsCutting) {
  Camera giant = at({1, 1, 1}, {3, 1, 1});
  giant.near_plane = 100;
  EXPECT_FALSE(nearPlaneIsInFreeSpace(grid_, giant.view()));
}

}  // namespace
}  // namespace enfilade
