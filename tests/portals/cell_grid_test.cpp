#include "portals/cell_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "scene/error.h"

namespace enfilade {
namespace {

using Label = CellGrid::Label;
constexpr Label kSolid = CellGrid::kSolidVoxel;
constexpr Label kCut = CellGrid::kCutVoxel;

std::vector<Label> labelsOf(const glm::ivec3& size,
                            const std::function<Label(const glm::ivec3&)>& label) {
  std::vector<Label> labels;
  for (int x = 0; x < size.x; ++x) {
    for (int z = 0; z < size.z; ++z) {
      for (int y = 0; y < size.y; ++y) labels.push_back(label({x, y, z}));
    }
  }
  return labels;
}

TEST(CellGrid, GivesBackEveryLabelOfADenseGrid) {
  const glm::ivec3 size(7, 23, 5);
  std::mt19937 random(1);
  const Label kinds[] = {0, 1, 1, 1, 2, kSolid, kCut};
  const auto labels = labelsOf(size, [&](const glm::ivec3&) { return kinds[random() % 7]; });
  const CellGrid grid({-1, 2, 3}, 0.25f, size, labels);
  std::size_t i = 0;
  for (int x = 0; x < size.x; ++x) {
    for (int z = 0; z < size.z; ++z) {
      for (int y = 0; y < size.y; ++y) ASSERT_EQ(grid.labelAt({x, y, z}), labels[i++]);
    }
  }
  for (const glm::ivec3 outside :
       {glm::ivec3(-1, 0, 0), glm::ivec3(0, 23, 0), glm::ivec3(0, 0, 5)}) {
    EXPECT_EQ(grid.labelAt(outside), kExterior);
  }
  const CellGrid again(grid.origin(), grid.voxel(), grid.size(),
                       {grid.firstRuns().begin(), grid.firstRuns().end()},
                       {grid.runs().begin(), grid.runs().end()});
  EXPECT_TRUE(std::ranges::equal(again.runs(), grid.runs()));
}

TEST(CellGrid, CodesABuildingSizedGridInAFewBytesAColumn) {
  const glm::ivec3 size(1000, 200, 1000);
  std::vector<std::uint32_t> first;
  std::vector<CellGrid::Run> runs;
  for (std::uint32_t column = 0; column <= 1000 * 1000; ++column) first.push_back(column * 3);
  for (int column = 0; column < 1000 * 1000; ++column) {
    runs.insert(runs.end(), {{1, kSolid}, {30, 1}, {200, kExterior}});
  }
  const CellGrid grid({0, 0, 0}, 0.1f, size, std::move(first), std::move(runs));
  EXPECT_EQ(grid.runs().size_bytes() + grid.firstRuns().size_bytes(), 16u * 1000 * 1000 + 4);
  EXPECT_EQ(grid.labelAt({999, 29, 999}), 1);
  EXPECT_EQ(grid.labelAt({999, 30, 999}), kExterior);
}

TEST(CellGrid, VoxelOfAndCenterOfAreInverse) {
  const CellGrid grid({-1, 2, 3}, 0.25f, {2, 2, 2}, std::vector<Label>(8, 0));
  for (const glm::ivec3 v : {glm::ivec3(0), glm::ivec3(1, 0, 1), glm::ivec3(-5, 8, -1)}) {
    EXPECT_EQ(grid.voxelOf(grid.centerOf(v)), v);
  }
  EXPECT_EQ(grid.labelAt(grid.voxelOf({NAN, INFINITY, -INFINITY})), kExterior);
}

TEST(CellGrid, RejectsRunsThatDoNotMakeAGrid) {
  using Runs = std::vector<CellGrid::Run>;
  using First = std::vector<std::uint32_t>;
  const auto rejects = [](const glm::ivec3& size, const First& first, const Runs& runs) {
    EXPECT_THROW(CellGrid({0, 0, 0}, 0.1f, size, first, runs), Error);
  };
  const glm::ivec3 size(1, 4, 2);
  const Runs good = {{4, 0}, {2, 1}, {4, 0}};
  EXPECT_NO_THROW(CellGrid({0, 0, 0}, 0.1f, size, First{0, 1, 3}, good));
  EXPECT_THROW(CellGrid({0, 0, 0}, -0.1f, size, First{0, 1, 3}, good), Error);
  EXPECT_THROW(CellGrid({0, NAN, 0}, 0.1f, size, First{0, 1, 3}, good), Error);
  rejects({0, 4, 2}, {0, 1, 3}, good);
  rejects({1, 70000, 2}, {0, 1, 3}, good);
  rejects(size, {0, 3}, good);
  rejects(size, {0, 1, 2}, good);
  rejects(size, {0, 0, 3}, good);
  rejects(size, {0, 4, 3}, good);
  rejects(size, {1, 1, 3}, good);
  rejects(size, {0, 1, 3}, {{4, 0}, {4, 1}, {4, 0}});
  rejects(size, {0, 1, 3}, {{4, 0}, {2, 1}, {3, 0}});
  rejects(size, {0, 1, 3}, {{5, 0}, {2, 1}, {4, 0}});
}

/// Two rooms, 1 at −x and 2 at +x of a wall at x in [1.9, 2.1], a doorway in the wall at z in
/// [1, 2], y in [0.1, 2.1], whose portal is the plane x = 2; solid shell, exterior around.
struct Rooms {
  CellGraph graph;
  CellGrid grid;

  static glm::vec3 center(const glm::ivec3& v) { return (glm::vec3(v) + 0.5f) * 0.1f - 0.5f; }

  static Label label(const glm::ivec3& v) {
    const glm::vec3 p = center(v);
    const bool inside = p.x > 0 && p.x < 4 && p.y > 0 && p.y < 2.5f && p.z > 0 && p.z < 3;
    const bool shell =
        p.x < 0.1f || p.x > 3.9f || p.y < 0.1f || p.y > 2.4f || p.z < 0.1f || p.z > 2.9f;
    if (!inside) return kExterior;
    if (shell) return kSolid;
    const bool doorway = p.z > 1 && p.z < 2 && p.y < 2.1f;
    if (p.x > 1.9f && p.x < 2.1f) return doorway ? kCut : kSolid;
    return p.x < 2 ? 1 : 2;
  }

  Rooms() {
    graph.cells.resize(3);
    Portal door;
    door.polygon = {{2, 0.1f, 2}, {2, 0.1f, 1}, {2, 2.1f, 1}, {2, 2.1f, 2}};
    door.plane = planeOf(door.polygon);
    door.front = 2;
    door.back = 1;
    graph.portals.push_back(door);
    linkCells(graph);
    const glm::ivec3 size(50, 35, 40);
    grid = CellGrid(glm::vec3(-0.5f), 0.1f, size, labelsOf(size, label));
  }

  CellLocation at(const glm::vec3& p) const { return locate(graph, grid, p); }
};

void expectAt(const Rooms& rooms, const glm::vec3& p, CellId cell, bool in_free_space) {
  const CellLocation found = rooms.at(p);
  EXPECT_EQ(found.cell, cell) << p.x << ' ' << p.y << ' ' << p.z;
  EXPECT_EQ(found.in_free_space, in_free_space) << p.x << ' ' << p.y << ' ' << p.z;
}

TEST(Locate, FreeSpaceIsTheCellOfItsVoxel) {
  const Rooms rooms;
  expectAt(rooms, {1, 1, 1}, 1, true);
  expectAt(rooms, {3, 1, 1}, 2, true);
  expectAt(rooms, {-0.3f, 1, 1}, kExterior, true);
  expectAt(rooms, {-100, 1, 1}, kExterior, true);
}

TEST(Locate, ThePortalsPlaneDecidesInTheDoorway) {
  const Rooms rooms;
  for (const float off : {0.001f, 0.03f, 0.09f}) {
    expectAt(rooms, {2 - off, 1, 1.5f}, 1, true);
    expectAt(rooms, {2 + off, 1, 1.5f}, 2, true);
  }
}

TEST(Locate, OverAStairThatThePortalRunsAlongTheSpaceBelongsToTheCellThatReachesAroundIt) {
  // Beyond the doorway a slab: room 1 is below it, above it room 2 reaches around the wall.
  Rooms rooms;
  const glm::ivec3 size(50, 35, 40);
  rooms.grid = CellGrid(glm::vec3(-0.5f), 0.1f, size, labelsOf(size, [](const glm::ivec3& v) {
                          const glm::vec3 p = Rooms::center(v);
                          const Label label = Rooms::label(v);
                          if (label == 1 && p.y > 1 && p.y < 1.1f) return kSolid;
                          return label == 1 && p.y > 1.1f ? Label{2} : label;
                        }));
  expectAt(rooms, {1.95f, 0.5f, 1.5f}, 1, true);
  expectAt(rooms, {1.95f, 1.5f, 1.5f}, 2, true);
  expectAt(rooms, {2.05f, 0.5f, 1.5f}, 2, true);
  expectAt(rooms, {2.05f, 1.5f, 1.5f}, 2, true);
}

TEST(Locate, InAWallTheNearestRoomIsFound) {
  const Rooms rooms;
  expectAt(rooms, {1.96f, 1, 0.5f}, 1, false);
  expectAt(rooms, {2.04f, 1, 0.5f}, 2, false);
  expectAt(rooms, {0.07f, 1, 1}, 1, false);
  expectAt(rooms, {0.02f, 1, 1}, kExterior, false);
  expectAt(rooms, {1, 2.43f, 1}, 1, false);
}

TEST(Locate, BesideADoorwayTheNearestRoomIsNotReachedThroughThePortal) {
  Rooms rooms;
  // A piece of furniture in the doorway on room 1's side: the nearest free voxels are room 2's.
  const glm::ivec3 size(50, 35, 40);
  rooms.grid = CellGrid(glm::vec3(-0.5f), 0.1f, size, labelsOf(size, [](const glm::ivec3& v) {
                          const glm::vec3 p = Rooms::center(v);
                          const bool block = p.x > 1.3f && p.x < 2.1f && p.y > 0.3f && p.y < 1.7f;
                          return block && p.z > 1 && p.z < 2 ? kSolid : Rooms::label(v);
                        }));
  expectAt(rooms, {1.9f, 1, 1.5f}, 1, false);
  expectAt(rooms, {2.05f, 1, 1.5f}, 2, false);
}

TEST(Locate, DeepInSomethingSolidStillFindsTheNearestCell) {
  CellGraph graph;
  graph.cells.resize(2);
  const glm::ivec3 size(60, 60, 60);
  const CellGrid grid({0, 0, 0}, 0.1f, size, labelsOf(size, [](const glm::ivec3& v) -> Label {
                        return v == glm::ivec3(20, 30, 40) ? 1 : kSolid;
                      }));
  std::mt19937 random(5);
  std::uniform_real_distribution<float> coordinate(0.01f, 5.99f);
  for (int trial = 0; trial < 200; ++trial) {
    const glm::vec3 p(coordinate(random), coordinate(random), coordinate(random));
    const glm::vec3 to_border = glm::min(p, 6.0f - p);
    const float exterior = std::min({to_border.x, to_border.y, to_border.z}) + 0.05f;
    const float room = glm::distance(p, grid.centerOf({20, 30, 40}));
    const CellLocation found = locate(graph, grid, p);
    if (room == 0 || grid.voxelOf(p) == glm::ivec3(20, 30, 40)) continue;
    EXPECT_EQ(found.cell, room < exterior ? 1u : kExterior);
    EXPECT_FALSE(found.in_free_space);
  }
}

}  // namespace
}  // namespace enfilade
