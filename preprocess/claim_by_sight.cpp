#include <tbb/parallel_for.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <random>

#include "preprocess/share_geometry.h"
#include "render/ray_caster.h"
#include "visibility/portal_walk.h"

namespace enfilade {

namespace {

constexpr int kRaysPerOrigin = 16;
constexpr int kOriginsPerBlock = 512;
constexpr int kMostPanes = 8;  // blended surfaces that a ray passes before it is given up

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

class SightLines {
 public:
  SightLines(const Building& building, const RayCaster& rays, const PortalWalker& walker,
             const Patches& patches)
      : building_(building), rays_(rays), walker_(walker), patches_(patches) {}

  // Claims what one ray meets, panes of glass on the way too.
  void follow(CellId start, const glm::vec3& origin, const glm::vec3& direction,
              std::vector<PortalCrossing>& crossings,
              std::vector<PatchCells::Claim>& claims) const {
    float passed = 0;
    for (int pane = 0; pane < kMostPanes; ++pane) {
      const RayHit hit =
          rays_.cast(origin, direction, passed, std::numeric_limits<float>::infinity(), false);
      if (hit.distance < 0) return;
      const CellId cell = walker_.walk(start, origin, direction, hit.distance, crossings);
      if (cell != kNoCell) {
        claims.push_back({patches_.patch_of_triangle[hit.object][hit.triangle], cell});
      }
      if (building_.materialOf(building_.objects[hit.object]).alpha_mode != AlphaMode::kBlend)
        return;
      passed = hit.distance + 1e-4f * (1.0f + hit.distance);
    }
  }

 private:
  const Building& building_;
  const RayCaster& rays_;
  const PortalWalker& walker_;
  const Patches& patches_;
};

glm::vec3 randomDirection(std::mt19937& random) {
  const auto unit = [&] { return static_cast<float>(random()) * 0x1p-32f; };
  const float y = 2 * unit() - 1;
  const float angle = 2 * std::numbers::pi_v<float> * unit();
  const float r = std::sqrt(std::max(0.0f, 1 - y * y));
  return {r * std::cos(angle), y, r * std::sin(angle)};
}

std::vector<PatchCells::Claim> claimsOfBlock(const CutCells& cells, const Origins& block,
                                             unsigned seed, const SightLines& sight) {
  std::mt19937 random(seed);
  std::vector<PatchCells::Claim> claims;
  std::vector<PortalCrossing> crossings;
  const auto size = cells.grid.size();
  const auto unit = [&] { return static_cast<float>(random()) * 0x1p-32f; };
  for (const std::size_t voxel : block.voxels) {
    const auto y = static_cast<int>(voxel % static_cast<std::size_t>(size.y));
    const std::size_t column = voxel / static_cast<std::size_t>(size.y);
    const auto z = static_cast<int>(column % static_cast<std::size_t>(size.z));
    const auto x = static_cast<int>(column / static_cast<std::size_t>(size.z));
    const glm::vec3 jitter = glm::vec3(unit(), unit(), unit()) - 0.5f;
    const glm::vec3 origin = cells.grid.centerOf({x, y, z}) + jitter * cells.grid.voxel();
    for (int r = 0; r < kRaysPerOrigin; ++r) {
      sight.follow(block.cell, origin, randomDirection(random), crossings, claims);
    }
  }
  PatchCells united{std::move(claims)};
  united.sortAndUnite();
  return united.claims;
}

}  // namespace

void claimBySight(const Building& building, std::span<const ObjectRole> roles,
                  const Patches& patches, const CutCells& cells, int rays_per_cell, int threads,
                  const std::function<void(double)>& progress, PatchCells& claims) {
  if (rays_per_cell <= 0) return;
  const RayCaster rays(building, doorFlags(roles), threads);
  const PortalWalker walker(cells.graph);
  const SightLines sight(building, rays, walker, patches);
  const std::vector<Origins> blocks = chooseOrigins(cells, rays_per_cell);
  std::vector<std::vector<PatchCells::Claim>> found(blocks.size());
  std::size_t done = 0;
  std::mutex telling;
  tbb::parallel_for(std::size_t{0}, blocks.size(), [&](std::size_t b) {
    found[b] = claimsOfBlock(cells, blocks[b], static_cast<unsigned>(b), sight);
    const std::lock_guard lock(telling);
    ++done;
    if (progress) progress(static_cast<double>(done) / static_cast<double>(blocks.size() + 1));
  });
  for (const auto& part : found)
    claims.claims.insert(claims.claims.end(), part.begin(), part.end());
  claims.sortAndUnite();
}

}  // namespace enfilade
