// McMillan & Bishop, Plenoptic Modeling, 1995; Rafferty et al., Images for Accelerating
// Architectural Walkthroughs, 1998, sec. 3.
#include "ibr/warp.h"

#include <algorithm>
#include <cassert>

#include "ibr/reconstruction.h"
#include "ibr/sheets.h"
#include "ibr/tile_clip.h"

namespace enfilade {
namespace {

/// Warps samples [first, beyond) of one tile, in that order.
void warpSamples(const Ldi& ldi, const TileTransform& transform, std::size_t first,
                 std::size_t beyond, const RegionOfBuffer& region) noexcept {
  WarpedBatch batch;
  for (std::size_t at = first; at < beyond; at += kWarpBatch) {
    const auto samples = std::span(ldi.samples).subspan(at, std::min(kWarpBatch, beyond - at));
    warpBatch(transform, samples, batch);
    addSamples(region, batch, samples);
  }
}

}  // namespace

void WarpBuffer::resize(int width, int height) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  color.width = width;
  color.height = height;
  color.rgba.assign(4 * pixels, 0);
  weighted.assign(pixels, glm::vec4(0.0f));
  nearest.assign(pixels, 0.0f);
  spans.assign(static_cast<std::size_t>(height), glm::ivec2(0));
}

WarpCounts warpLdi(const Ldi& ldi, const PlanarCamera& desired, std::span<const glm::vec2> polygon,
                   WarpBuffer& target, const WarpOptions& options) noexcept {
  assert(desired.width == target.color.width && desired.height == target.color.height);
  const RegionOfBuffer region{
      target, fillConvexPolygon(polygon, desired.width, desired.height, target.spans)};
  clearRegion(region);

  WarpCounts counts;
  const WarpTransform warp = warpTransform(ldi.camera, desired);
  const TileClip clip(polygon);
  visitInSheets(ldi, sheetOrder(ldi.camera, desired.center), [&](const LdiTile& tile) {
    const TileTransform transform = tileTransform(warp, tile);
    if (options.clip && !clip.mayReach(tile, transform)) {
      counts.samples_clipped += tile.count;
      return;
    }
    counts.samples += tile.count;
    warpSamples(ldi, transform, tile.first, tile.first + tile.count, region);
  });
  resolveRegion(region, counts);
  return counts;
}

}  // namespace enfilade
