#include "preprocess/voxel_grid.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "preprocess/triangle_columns.h"
#include "render/parallel_for.h"
#include "scene/error.h"
#include "scene/extent_doubts.h"

namespace enfilade {

namespace {

/// Touching counts, rounding too [voxels].
constexpr double kEpsilon = 1e-3;

/// With what later stages keep for each voxel, 512 Mi voxels take some 4 GiB.
constexpr double kMostVoxels = 512.0 * 1024 * 1024;
constexpr double kMostVoxelsAlongAnAxis = 65535;

/// Walls tend to lie on round numbers: fractions of a voxel that no round number of voxels gives.
constexpr std::array<double, 3> kGridOffset{0.3819660113, 0.4142135624, 0.2360679775};

/// A triangle in voxel units from the grid's origin.
struct VoxelTriangle {
  std::array<glm::dvec3, 3> corners;
  std::uint8_t bit = 0;
};

/// Marks the voxels of `triangle` with first_x ≤ x < end_x.
void fill(const VoxelTriangle& triangle, int first_x, int end_x, VoxelGrid& grid) {
  TriangleColumns(triangle.corners, kEpsilon)
      .forEach({first_x, 0, 0}, {end_x, grid.size.y, grid.size.z},
               [&](int x, int z, int y0, int y1) {
                 for (int y = y0; y <= y1; ++y) grid.bits[grid.index(x, y, z)] |= triangle.bit;
               });
}

std::uint8_t bitOf(const Building& building, const Object& object, ObjectRole role) {
  if (role == ObjectRole::kDoor) return kVoxelDoor;
  if (role == ObjectRole::kGlass) return kVoxelGlass;
  return building.materialOf(object).alpha_mode == AlphaMode::kBlend ? kVoxelGlass : kVoxelSolid;
}

[[noreturn]] void throwBadVertices(const Building& building) {
  throw Error(ErrorKind::kBadInput, building.name, "has vertices that are no numbers, or far off");
}

std::vector<VoxelTriangle> trianglesOf(const Building& building, std::span<const ObjectRole> roles,
                                       const VoxelGrid& grid) {
  std::vector<VoxelTriangle> triangles;
  triangles.reserve(triangleCount(building));
  for (std::size_t o = 0; o < building.objects.size(); ++o) {
    const Object& object = building.objects[o];
    const Mesh& mesh = building.meshOf(object);
    const auto& positions = building.vertex_arrays[mesh.vertices].positions;
    const glm::dmat4 world_from_object(building.worldFromObject(object));
    const std::uint8_t bit = bitOf(building, object, roles[o]);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      VoxelTriangle triangle{.corners = {}, .bit = bit};
      for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec4 corner(positions[mesh.indices[i + k]], 1.0);
        triangle.corners[k] = (glm::dvec3(world_from_object * corner) - glm::dvec3(grid.origin)) /
                              static_cast<double>(grid.voxel);
        if (!std::isfinite(triangle.corners[k].x + triangle.corners[k].y + triangle.corners[k].z)) {
          throwBadVertices(building);
        }
      }
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

/// The size of the grid over `extent` [m]; may be too large for an int.
glm::dvec3 sizeOver(const glm::dvec3& extent, double voxel, int margin) {
  const glm::dvec3 offset(kGridOffset[0], kGridOffset[1], kGridOffset[2]);
  return glm::ceil(extent / voxel + offset) + glm::dvec3(2.0 * margin);
}

bool fits(const glm::dvec3& size) {
  return size.x * size.y * size.z <= kMostVoxels &&
         std::max({size.x, size.y, size.z}) <= kMostVoxelsAlongAnAxis;
}

/// Throws unless a grid over `bounds` fits in memory.
void checkFits(const Building& building, const Box& bounds, float voxel, int margin) {
  const glm::dvec3 extent(bounds.size());
  const float step = coordinateStep(bounds);
  if (!(glm::dot(extent, extent) < 1e18)) throwBadVertices(building);
  if (fits(sizeOver(extent, voxel, margin))) {
    if (step <= voxel / 2) return;
    throw Error(ErrorKind::kBadInput, building.name,
                "stands so far from the origin that its coordinates lie " + lengthText(step) +
                    " apart, too coarse for voxels of " + lengthText(voxel) + "; move it nearer");
  }
  double enough = voxel;
  while (!fits(sizeOver(extent, enough, margin))) enough *= 1.05;
  enough = std::ceil(enough * 100) / 100;
  constexpr double kLargestThatFindsDoors = 1.0;
  const auto text = [](double length) { return lengthText(static_cast<float>(length)); };
  const std::string advice = enough <= kLargestThatFindsDoors
                                 ? "voxels of " + text(enough) +
                                       " would do, or leave out what stands far from the building"
                                 : "are its lengths in metres, and nothing far from the building?";
  throw Error(ErrorKind::kBadInput, building.name,
              "is " + text(extent.x) + " × " + text(extent.y) + " × " + text(extent.z) +
                  ": too large for voxels of " + text(voxel) + "; " + advice);
}

}  // namespace

VoxelGrid voxelise(const Building& building, std::span<const ObjectRole> roles, float voxel,
                   int margin) {
  assert(voxel > 0 && margin >= 0);
  assert(roles.size() == building.objects.size());
  const Box bounds = worldBounds(building);
  if (bounds.empty()) throw Error(ErrorKind::kBadInput, building.name, "has no triangles");
  checkFits(building, bounds, voxel, margin);

  VoxelGrid grid;
  grid.voxel = voxel;
  grid.size = glm::ivec3(sizeOver(glm::dvec3(bounds.size()), voxel, margin));
  const glm::dvec3 offset(kGridOffset[0], kGridOffset[1], kGridOffset[2]);
  grid.origin = glm::vec3(glm::dvec3(bounds.min) -
                          static_cast<double>(voxel) * (offset + static_cast<double>(margin)));
  grid.bits.assign(grid.index(grid.size.x - 1, grid.size.y - 1, grid.size.z - 1) + 1, 0);

  // Slabs of columns: no two threads write the same voxel.
  const auto triangles = trianglesOf(building, roles, grid);
  constexpr int kSlab = 32;
  const auto slabs = static_cast<std::size_t>((grid.size.x + kSlab - 1) / kSlab);
  parallelFor(slabs, [&](std::size_t slab) {
    const int first_x = static_cast<int>(slab) * kSlab,
              end_x = std::min(first_x + kSlab, grid.size.x);
    for (const VoxelTriangle& triangle : triangles) fill(triangle, first_x, end_x, grid);
  });
  return grid;
}

}  // namespace enfilade
