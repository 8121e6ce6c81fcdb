#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

#include "preprocess/portal_polygon.h"
#include "preprocess/share_geometry.h"
#include "preprocess/triangle_columns.h"

namespace enfilade {

void PatchCells::sortAndUnite() {
  std::sort(claims.begin(), claims.end());
  claims.erase(std::unique(claims.begin(), claims.end()), claims.end());
}

namespace {

// A voxel beside one that is touched counts: faces stand on the border of free space [voxels].
constexpr double kBeside = 1.0;

// Cells this near [m] may see what no free voxel stands beside.
constexpr double kHiddenReach = 1.0;

// Voxels that a portal cuts, with the cells on its two sides.
using CutSides = std::vector<std::pair<std::size_t, std::array<CellId, 2>>>;

CutSides cutSides(const VoxelGrid& grid, const CutCells& cells) {
  CutSides sides;
  for (const Portal& portal : cells.graph.portals) {
    const auto grown = growPolygon(portal.polygon, portal.plane, grid.voxel);
    forEachTouchedVoxel(grown, portal.plane, grid, [&](const glm::ivec3& v) {
      sides.push_back({grid.index(v.x, v.y, v.z), {portal.front, portal.back}});
    });
  }
  std::sort(sides.begin(), sides.end());
  return sides;
}

// The cells beside a triangle, few and unordered.
class Claimer {
 public:
  Claimer(const VoxelGrid& grid, const CutCells& cells)
      : grid_(grid), labels_(cells.labels), cut_sides_(cutSides(grid, cells)) {}

  void claim(const std::array<glm::dvec3, 3>& triangle, double growth, std::vector<CellId>& out) {
    out.clear();
    CellGrid::Label last = CellGrid::kSolidVoxel;
    TriangleColumns(triangle, growth)
        .forEach({0, 0, 0}, grid_.size, [&](int x, int z, int y0, int y1) {
          std::size_t i = grid_.index(x, y0, z);
          for (int y = y0; y <= y1; ++y, ++i) {
            const CellGrid::Label label = labels_[i];
            if (label == last || label == CellGrid::kSolidVoxel) continue;
            if (label == CellGrid::kCutVoxel) {
              claimCut(i, out);
            } else {
              add(label, out);
              last = label;
            }
          }
        });
  }

 private:
  static void add(CellId cell, std::vector<CellId>& out) {
    if (std::find(out.begin(), out.end(), cell) == out.end()) out.push_back(cell);
  }
  void claimCut(std::size_t voxel, std::vector<CellId>& out) const {
    auto at = std::lower_bound(cut_sides_.begin(), cut_sides_.end(), voxel,
                               [](const auto& side, std::size_t v) { return side.first < v; });
    for (; at != cut_sides_.end() && at->first == voxel; ++at) {
      for (const CellId cell : at->second) add(cell, out);
    }
  }

  const VoxelGrid& grid_;
  const std::vector<CellGrid::Label>& labels_;
  CutSides cut_sides_;
};

std::array<glm::dvec3, 3> inVoxels(const VoxelGrid& grid, const Building& building,
                                   const Object& object, std::size_t triangle) {
  const Mesh& mesh = building.meshOf(object);
  const auto& positions = building.vertex_arrays[mesh.vertices].positions;
  const glm::dmat4 world_from_object(building.worldFromObject(object));
  std::array<glm::dvec3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const glm::dvec4 p(positions[mesh.indices[3 * triangle + k]], 1.0);
    corners[k] = (glm::dvec3(world_from_object * p) - glm::dvec3(grid.origin)) /
                 static_cast<double>(grid.voxel);
  }
  return corners;
}

}  // namespace

PatchCells claimByTouch(const Building& building, const Patches& patches, const VoxelGrid& voxels,
                        const CutCells& cells) {
  PatchCells out;
  std::vector<std::uint8_t> claimed(patches.count, 0);
  Claimer claimer(voxels, cells);
  std::vector<CellId> beside;
  const auto claimAll = [&](double growth, bool unclaimed_only) {
    for (std::size_t o = 0; o < building.objects.size(); ++o) {
      const auto& patch = patches.patch_of_triangle[o];
      for (std::size_t t = 0; t < patch.size(); ++t) {
        if (unclaimed_only && claimed[patch[t]] == 1) continue;
        claimer.claim(inVoxels(voxels, building, building.objects[o], t), growth, beside);
        for (const CellId cell : beside) out.claims.push_back({patch[t], cell});
        if (!beside.empty()) claimed[patch[t]] = unclaimed_only ? 2 : 1;
      }
    }
    for (std::uint8_t& flag : claimed) flag = flag != 0;
  };
  claimAll(kBeside, false);
  // What stands inside walls and furniture: to all cells near by, for each may look into its
  // cracks; with none, to the nearest, so that no triangle is lost.  Sight lines may add more.
  for (double growth = kHiddenReach / voxels.voxel; growth <= 64; growth *= 2) {
    claimAll(growth, true);
  }
  for (std::uint32_t p = 0; p < patches.count; ++p) {
    if (!claimed[p]) out.claims.push_back({p, kExterior});
  }
  out.sortAndUnite();
  return out;
}

}  // namespace enfilade
