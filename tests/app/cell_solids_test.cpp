#include "app/cell_solids.h"

#include <gtest/gtest.h>

#include "portals/cell_graph.h"
#include "scene/gltf_reader.h"
#include "scene/gltf_writer.h"
#include "tests/app/temporary_folder.h"
#include "tests/app/two_room_house.h"

namespace enfilade {
namespace {

/// The volume that closed triangles bound, counter-clockwise from outside [m³], and the sum of
/// their areas as vectors, which is 0 if they are closed.
struct Bounded {
  double volume = 0;
  glm::dvec3 area{0};
};

Bounded boundedBy(const Building& building, const Object& object) {
  const Mesh& mesh = building.meshOf(object);
  const auto& positions = building.vertex_arrays[mesh.vertices].positions;
  Bounded sum;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const glm::dvec3 a(positions[mesh.indices[i]]);
    const glm::dvec3 b(positions[mesh.indices[i + 1]]);
    const glm::dvec3 c(positions[mesh.indices[i + 2]]);
    sum.volume += glm::dot(a, glm::cross(b, c)) / 6;
    sum.area += glm::cross(b - a, c - a) / 2.0;
  }
  return sum;
}

double voxelsVolume(const CellGrid& grid, CellId cell) {
  std::size_t voxels = 0;
  for (int x = 0; x < grid.size().x; ++x) {
    for (int z = 0; z < grid.size().z; ++z) {
      for (int y = 0; y < grid.size().y; ++y) voxels += grid.labelAt({x, y, z}) == cell;
    }
  }
  return static_cast<double>(voxels) * std::pow(static_cast<double>(grid.voxel()), 3);
}

/// A house whose grid is a heap of random labels.
House confusedHouse() {
  House house = twoRoomHouse();
  std::vector<CellGrid::Label> labels;
  std::uint32_t random = 1;
  for (int i = 0; i < 7 * 9 * 5; ++i) {
    random = random * 1664525u + 1013904223u;
    const std::uint32_t draw = random >> 29;
    labels.push_back(draw < house.graph.cells.size() ? static_cast<CellGrid::Label>(draw)
                     : draw & 1u                     ? CellGrid::kSolidVoxel
                                                     : CellGrid::kCutVoxel);
  }
  house.grid = CellGrid({-1, 0.5f, 2}, 0.3f, {7, 9, 5}, labels);
  return house;
}

TEST(CellSolids, BoundWhatTheVoxelsOfEachCellHold) {
  for (const House& house : {twoRoomHouse(), confusedHouse()}) {
    const Building solids = cellSolids(house);
    const std::size_t cells = house.graph.cells.size();
    ASSERT_EQ(solids.objects.size(), cells - 1 + house.graph.portals.size());
    for (CellId cell = 1; cell < cells; ++cell) {
      const Object& object = solids.objects[cell - 1];
      EXPECT_EQ(solids.nodes[object.node].name, house.graph.cells[cell].name);
      const double volume = voxelsVolume(house.grid, cell);
      ASSERT_GT(volume, 0);
      const Bounded bounded = boundedBy(solids, object);
      EXPECT_NEAR(bounded.volume, volume, 1e-4 * volume);
      EXPECT_LT(glm::length(bounded.area), 1e-4);
    }
  }
}

TEST(CellSolids, HoldEveryPortalAsItIs) {
  House house = twoRoomHouse();
  house.graph.portals[0].active = false;
  const Building solids = cellSolids(house);
  const std::size_t first = house.graph.cells.size() - 1;
  for (std::size_t p = 0; p < house.graph.portals.size(); ++p) {
    const Portal& portal = house.graph.portals[p];
    const Object& object = solids.objects[first + p];
    EXPECT_EQ(solids.nodes[object.node].name, portal.name);
    const Bounded bounded = boundedBy(solids, object);
    EXPECT_NEAR(glm::dot(bounded.area, glm::dvec3(portal.plane.normal)),
                static_cast<double>(portal.area()), 1e-4);
    const glm::vec4 color = solids.materialOf(object).base_color;
    EXPECT_EQ(color.r == color.g && color.g == color.b, !portal.active);
  }
}

TEST(CellSolids, CanBeWrittenAndReadAgain) {
  const TemporaryFolder folder;
  const Building solids = cellSolids(twoRoomHouse());
  writeGlb(folder / "cells.glb", solids);
  const Building read = readGltf(folder / "cells.glb");
  EXPECT_EQ(triangleCount(read), triangleCount(solids));
  EXPECT_EQ(read.objects.size(), solids.objects.size());
}

}  // namespace
}  // namespace enfilade
