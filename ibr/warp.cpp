// McMillan & Bishop, Plenoptic Modeling, 1995; Rafferty et al., Images for Accelerating
// Architectural Walkthroughs, 1998, sec. 3.
#include "ibr/warp.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "ibr/reconstruction.h"
#include "ibr/sheets.h"
#include "ibr/tile_clip.h"

namespace enfilade {
namespace {

void warpSamples(const Ldi& ldi, const TileTransform& transform, const LdiTile& tile,
                 const RegionOfBuffer& region) noexcept {
  WarpedBatch batch;
  const std::size_t first = tile.first;
  const std::size_t beyond = first + tile.count;
  for (std::size_t at = first; at < beyond; at += kWarpBatch) {
    const auto samples = std::span(ldi.samples).subspan(at, std::min(kWarpBatch, beyond - at));
    warpBatch(transform, samples, batch);
    addSamples(region, batch, samples);
  }
}

/// What a warp of one image into one region needs.
struct Warp {
  const Ldi& ldi;
  WarpTransform transform;
  SheetOrder order;
  const TileClip& region_clip;
  bool clips;
};

/// Warps what falls into a band of the region.  The counts of samples are those of the region.
WarpCounts warpInto(const Warp& warp, const RegionOfBuffer& band) noexcept {
  WarpCounts counts;
  visitInSheets(warp.ldi, warp.order, [&](const LdiTile& tile) {
    const TileTransform transform = tileTransform(warp.transform, tile);
    const RowsReached rows = warp.region_clip.rowsReached(tile, transform);
    (rows.empty() && warp.clips ? counts.samples_clipped : counts.samples) += tile.count;
    const bool in_band = rows.top <= static_cast<float>(band.rows.bottom) &&
                         rows.bottom >= static_cast<float>(band.rows.top);
    if (!warp.clips || (!rows.empty() && in_band)) {
      warpSamples(warp.ldi, transform, tile, band);
    }
  });
  return counts;
}

constexpr int kMostBands = 64;
constexpr int kLeastRowsOfBand = 48;  // a tile that lies in two bands is warped in both

int bandCount(const RegionOfBuffer& region, int threads) noexcept {
  const int at_once = threads > 0 ? threads : tbb::this_task_arena::max_concurrency();
  const int rows = region.rows.bottom - region.rows.top;
  return std::clamp(rows / kLeastRowsOfBand, 1, std::min(at_once, kMostBands));
}

/// Band i of n: its share of the region's rows.
RegionOfBuffer bandOf(const RegionOfBuffer& region, int i, int n) noexcept {
  const int rows = region.rows.bottom - region.rows.top;
  RegionOfBuffer band = region;
  band.rows = {region.rows.top + rows * i / n, region.rows.top + rows * (i + 1) / n};
  return band;
}

template <class Work>
void forEachBand(int bands, Work&& work) noexcept {
  if (bands == 1) {
    work(0);
  } else {
    tbb::parallel_for(0, bands, work, tbb::simple_partitioner());
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

WarpCounts warpImages(std::span<const Ldi* const> images, const PlanarCamera& desired,
                      std::span<const glm::vec2> polygon, WarpBuffer& target,
                      const WarpOptions& options) noexcept {
  assert(desired.width == target.color.width && desired.height == target.color.height);
  const RegionOfBuffer region = regionOf(polygon, target);
  const TileClip clip(polygon);

  // A pixel's samples come in the same order whatever band it lies in.
  const int bands = bandCount(region, options.threads);
  std::array<WarpCounts, kMostBands> counts;
  forEachBand(bands, [&](int i) {
    const RegionOfBuffer band = bandOf(region, i, bands);
    clearRegion(band);
    WarpCounts& sum = counts[static_cast<std::size_t>(i)];
    for (const Ldi* image : images) {
      const Warp warp{*image, warpTransform(image->camera, desired),
                      sheetOrder(image->camera, desired.center), clip, options.clip};
      const WarpCounts more = warpInto(warp, band);
      sum.samples += more.samples;
      sum.samples_clipped += more.samples_clipped;
    }
  });
  forEachBand(bands, [&](int i) {
    resolveRegion(region, bandOf(region, i, bands).rows, counts[static_cast<std::size_t>(i)]);
  });
  for (int i = 1; i < bands; ++i) {
    const WarpCounts& more = counts[static_cast<std::size_t>(i)];
    counts[0].pixels += more.pixels;
    counts[0].pixels_uncovered += more.pixels_uncovered;
    counts[0].pixels_bridged += more.pixels_bridged;
  }
  return counts[0];
}

WarpCounts warpLdi(const Ldi& ldi, const PlanarCamera& desired, std::span<const glm::vec2> region,
                   WarpBuffer& target, const WarpOptions& options) noexcept {
  const Ldi* const image = &ldi;
  return warpImages({&image, 1}, desired, region, target, options);
}

}  // namespace enfilade
