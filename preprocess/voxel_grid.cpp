// Akenine-Möller, Fast 3D Triangle-Box Overlap Testing, 2001.  The thirteen separating axes are
// turned into linear bounds on y, so that a column of voxels is filled at once.
#include "preprocess/voxel_grid.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

#include "scene/error.h"

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

/// lo ≤ axis · centre ≤ hi for the centres of all boxes that this axis does not separate.
struct AxisBounds {
  glm::dvec3 axis{0};
  double lo = 0, hi = 0;
};

AxisBounds boundsAlong(const glm::dvec3& axis, const VoxelTriangle& triangle) {
  const glm::dvec3 d(glm::dot(axis, triangle.corners[0]), glm::dot(axis, triangle.corners[1]),
                     glm::dot(axis, triangle.corners[2]));
  const double reach = (0.5 + kEpsilon) * (std::abs(axis.x) + std::abs(axis.y) + std::abs(axis.z));
  return {axis, std::min({d.x, d.y, d.z}) - reach, std::max({d.x, d.y, d.z}) + reach};
}

/// Every axis but the box's own x and z, which bound the loops over columns.
std::array<AxisBounds, 11> separatingAxes(const VoxelTriangle& triangle) {
  const auto& c = triangle.corners;
  const std::array<glm::dvec3, 3> edges{c[1] - c[0], c[2] - c[1], c[0] - c[2]};
  std::array<AxisBounds, 11> bounds;
  bounds[0] = boundsAlong({0, 1, 0}, triangle);
  bounds[1] = boundsAlong(glm::cross(edges[0], edges[1]), triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& e = edges[i];
    bounds[2 + 3 * i] = boundsAlong({0, e.z, -e.y}, triangle);
    bounds[3 + 3 * i] = boundsAlong({-e.z, 0, e.x}, triangle);
    bounds[4 + 3 * i] = boundsAlong({e.y, -e.x, 0}, triangle);
  }
  return bounds;
}

/// The range of voxel indices whose centres lie in [lo, hi].
int firstIndex(double lo) { return static_cast<int>(std::ceil(lo - 0.5)); }
int lastIndex(double hi) { return static_cast<int>(std::floor(hi - 0.5)); }

struct Range {
  double lo = -std::numeric_limits<double>::infinity();
  double hi = std::numeric_limits<double>::infinity();
};

/// The y of the centres of the boxes in column (x, z) that touch the triangle.
Range columnRange(const std::array<AxisBounds, 11>& bounds, double x, double z) {
  Range range;
  for (const AxisBounds& b : bounds) {
    const double rest = b.axis.x * x + b.axis.z * z;
    if (b.axis.y > 0) {
      range.lo = std::max(range.lo, (b.lo - rest) / b.axis.y);
      range.hi = std::min(range.hi, (b.hi - rest) / b.axis.y);
    } else if (b.axis.y < 0) {
      range.lo = std::max(range.lo, (b.hi - rest) / b.axis.y);
      range.hi = std::min(range.hi, (b.lo - rest) / b.axis.y);
    } else if (rest < b.lo || rest > b.hi) {
      return {1, 0};
    }
  }
  return range;
}

/// Marks the voxels of `triangle` with first_x ≤ x < end_x.
void fill(const VoxelTriangle& triangle, int first_x, int end_x, VoxelGrid& grid) {
  const AxisBounds along_x = boundsAlong({1, 0, 0}, triangle);
  const int x0 = std::max(first_x, firstIndex(along_x.lo));
  const int x1 = std::min(end_x - 1, lastIndex(along_x.hi));
  if (x0 > x1) return;
  const AxisBounds along_z = boundsAlong({0, 0, 1}, triangle);
  const int z0 = std::max(0, firstIndex(along_z.lo));
  const int z1 = std::min(grid.size.z - 1, lastIndex(along_z.hi));
  const auto bounds = separatingAxes(triangle);
  for (int x = x0; x <= x1; ++x) {
    for (int z = z0; z <= z1; ++z) {
      const Range range = columnRange(bounds, x + 0.5, z + 0.5);
      if (range.lo > range.hi) continue;
      const int y0 = std::max(0, firstIndex(range.lo));
      const int y1 = std::min(grid.size.y - 1, lastIndex(range.hi));
      for (int y = y0; y <= y1; ++y) grid.bits[grid.index(x, y, z)] |= triangle.bit;
    }
  }
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
  if (!(glm::dot(extent, extent) < 1e18)) throwBadVertices(building);
  if (fits(sizeOver(extent, voxel, margin))) return;
  double enough = voxel;
  while (!fits(sizeOver(extent, enough, margin))) enough *= 1.05;
  enough = std::ceil(enough * 100) / 100;
  const auto metres = [](double length) {
    return std::to_string(length).substr(0, std::to_string(length).find('.') + 3) + " m";
  };
  throw Error(ErrorKind::kBadInput, building.name,
              "is " + metres(extent.x) + " × " + metres(extent.y) + " × " + metres(extent.z) +
                  ": too large for voxels of " + metres(voxel) + "; voxels of " + metres(enough) +
                  " would do, or leave out what stands far from the building");
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
  tbb::parallel_for(0, (grid.size.x + kSlab - 1) / kSlab, [&](int slab) {
    const int first_x = slab * kSlab, end_x = std::min(first_x + kSlab, grid.size.x);
    for (const VoxelTriangle& triangle : triangles) fill(triangle, first_x, end_x, grid);
  });
  return grid;
}

}  // namespace enfilade
