#include <mutex>
#include <random>

#include "preprocess/crack_search.h"
#include "preprocess/patch_views.h"
#include "preprocess/random_sphere.h"
#include "preprocess/share_geometry.h"
#include "preprocess/sight_claims.h"
#include "render/parallel_for.h"
#include "render/ray_caster.h"

namespace enfilade {

namespace {

constexpr int kRaysPerOrigin = 16;
constexpr int kOriginsPerBlock = 512;

// Places in free space from which a cell's rays start, spread evenly over its voxels.
struct Origins {
  CellId cell = 0;
  std::vector<std::size_t> voxels;
};

std::vector<std::size_t> voxelsOfEachCell(const CutCells& cells) {
  std::vector<std::size_t> count(cells.graph.cells.size(), 0);
  for (const CellGrid::Label label : cells.labels) {
    if (label < count.size()) ++count[label];
  }
  return count;
}

std::vector<Origins> chooseOrigins(const CutCells& cells, int rays_per_cell) {
  const std::vector<std::size_t> count = voxelsOfEachCell(cells);
  const auto wanted =
      static_cast<std::size_t>((rays_per_cell + kRaysPerOrigin - 1) / kRaysPerOrigin);
  std::vector<std::size_t> seen(count.size(), 0);
  std::vector<Origins> blocks;
  std::vector<Origins> open(count.size());
  for (std::size_t i = 0; i < cells.labels.size(); ++i) {
    const CellGrid::Label cell = cells.labels[i];
    if (cell >= count.size()) continue;
    // The origins among the first k voxels are k · wanted / count: even, and exactly `wanted` in
    // all.
    const std::size_t k = seen[cell]++;
    const std::size_t here = (k + 1) * wanted / count[cell] - k * wanted / count[cell];
    for (std::size_t n = 0; n < here; ++n) {
      open[cell].cell = cell;
      open[cell].voxels.push_back(i);
      if (open[cell].voxels.size() < kOriginsPerBlock) continue;
      blocks.push_back(std::move(open[cell]));
      open[cell] = {};
    }
  }
  for (Origins& rest : open) {
    if (!rest.voxels.empty()) blocks.push_back(std::move(rest));
  }
  return blocks;
}

/// What random lines from the origins of a block meet.
Sighted sightsOfBlock(const CutCells& cells, const Origins& block, unsigned seed,
                      const SightClaims& sight) {
  std::mt19937 random(seed);
  Sighted found;
  const auto size = cells.grid.size();
  for (const std::size_t voxel : block.voxels) {
    const auto y = static_cast<int>(voxel % static_cast<std::size_t>(size.y));
    const std::size_t column = voxel / static_cast<std::size_t>(size.y);
    const auto z = static_cast<int>(column % static_cast<std::size_t>(size.z));
    const auto x = static_cast<int>(column / static_cast<std::size_t>(size.z));
    const glm::vec3 jitter = 0.5f * randomInCube(random);
    const glm::vec3 origin = cells.grid.centerOf({x, y, z}) + jitter * cells.grid.voxel();
    for (int r = 0; r < kRaysPerOrigin; ++r) {
      sight.follow(block.cell, origin, randomDirection(random), found);
    }
  }
  // Of many blocks, no more is kept than will be needed.
  PatchCells united{std::move(found.claims)};
  united.sortAndUnite();
  return {{united.claims.begin(), united.claims.end()},
          oneOfEachPlace(std::move(found.cracks), sight.voxel()),
          {}};
}

}  // namespace

void claimBySight(const Building& building, std::span<const ObjectRole> roles,
                  const Patches& patches, const CutCells& cells, int rays_per_cell, int threads,
                  const std::function<void(double)>& progress, PatchCells& claims) {
  if (rays_per_cell <= 0) return;
  const RayCaster rays(building, doorFlags(roles), threads);
  const PortalWalker walker(cells.graph);
  const SightClaims sight(building, rays, walker, patches, cells);
  const std::vector<Origins> blocks = chooseOrigins(cells, rays_per_cell);
  std::vector<Sighted> found(blocks.size());
  std::size_t done = 0;
  std::mutex telling;
  parallelFor(blocks.size(), [&](std::size_t b) {
    found[b] = sightsOfBlock(cells, blocks[b], static_cast<unsigned>(b), sight);
    const std::lock_guard lock(telling);
    ++done;
    if (progress) progress(static_cast<double>(done) / static_cast<double>(blocks.size() + 1));
  });
  const std::size_t lines = blocks.size() * kOriginsPerBlock * kRaysPerOrigin;
  std::vector<CrackLine> cracks = lookFromPatches(building, patches, rays, sight, lines);
  const std::vector<CrackLine> more = cracksOf(found);
  cracks.insert(cracks.end(), more.begin(), more.end());
  searchCracks(sight, std::move(cracks), claims);
  addClaims(found, claims);
}

}  // namespace enfilade
