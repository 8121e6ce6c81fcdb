// McMillan & Bishop, Plenoptic Modeling, 1995; Rafferty et al., Images for Accelerating
// Architectural Walkthroughs, 1998, sec. 3.
#include "ibr/warp.h"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <array>
#include <cassert>

#include "ibr/clip_columns.h"
#include "ibr/convex_region.h"
#include "ibr/lay_patches.h"
#include "ibr/paint_splats.h"
#include "ibr/resolve.h"
#include "ibr/sheets.h"
#include "ibr/warp_scratch.h"

namespace enfilade {
namespace {

/// One image on its way into a region.
struct ImageWarp {
  const Ldi& ldi;
  WarpTransform transform;
  SheetOrder order;
  std::span<ScreenBox> boxes;  ///< where each tile's samples may fall
};

ImageWarp imageWarp(const Ldi& ldi, const PlanarCamera& desired, std::span<ScreenBox> boxes) {
  return {ldi, warpTransform(ldi.camera, desired), sheetOrder(ldi.camera, desired.center), boxes};
}

constexpr ScreenBox kEverywhere{-1e30f, -1e30f, 1e30f, 1e30f};

/// Sets the boxes of the image's tiles.
void clipTiles(const ImageWarp& image, const RegionClip& region, Clip clip) noexcept {
  switch (clip) {
    case Clip::kNothing:
      std::fill(image.boxes.begin(), image.boxes.end(), kEverywhere);
      break;
    case Clip::kColumns:
      clipByColumns(image.ldi, image.transform, region, image.boxes);
      break;
    case Clip::kTiles:
      for (std::size_t i = 0; i < image.boxes.size(); ++i) {
        const LdiTile& tile = image.ldi.tiles[i];
        image.boxes[i] = region.reached(boxOf(tile), tileTransform(image.transform, tile));
      }
  }
}

/// A warp of some images into one region.
struct RegionWarp {
  const PlanarCamera& desired;
  std::span<const Ldi* const> images;
  WarpBuffer& target;
  const WarpOptions& options;
  WarpPlan& plan;
  RowRange rows;
  WarpCounts counts;

  void clip(std::span<const glm::vec2> polygon) noexcept;
  std::size_t cut() noexcept;
  void warpFragment(const Fragment& fragment, WarpCounts& sum) const noexcept;
  void warpInto(const WarpWindow& window, const Fragment& fragment) const noexcept;

  /// Calls visit(image, first), where first is the index of its first tile's box.
  template <class Visit>
  void forEachImage(Visit&& visit) const noexcept {
    std::size_t first = 0;
    for (const Ldi* ldi : images) {
      visit(imageWarp(*ldi, desired, std::span(plan.boxes).subspan(first, ldi->tiles.size())));
      first += ldi->tiles.size();
    }
  }
};

void RegionWarp::clip(std::span<const glm::vec2> polygon) noexcept {
  std::size_t tiles = 0;
  for (const Ldi* ldi : images) tiles += ldi->tiles.size();
  plan.boxes.resize(tiles);
  const auto height = static_cast<std::size_t>(desired.height);
  if (plan.spans.size() < height) plan.spans.resize(height);
  rows = fillConvexPolygon(polygon, desired.width, desired.height, plan.spans);
  const RegionClip region(polygon, options.splat);
  forEachImage([&](const ImageWarp& image) {
    clipTiles(image, region, options.clip);
    for (std::size_t i = 0; i < image.boxes.size(); ++i) {
      const std::size_t count = image.ldi.tiles[i].count;
      (image.boxes[i].empty() ? counts.samples_clipped : counts.samples) += count;
    }
  });
}

/// Smaller warps are not worth a second thread.
constexpr std::size_t kSamplesOfAFragment = 8192;

std::size_t RegionWarp::cut() noexcept {
  const int at_once =
      options.threads > 0 ? options.threads : tbb::this_task_arena::max_concurrency();
  const int worth = static_cast<int>(
      std::min(counts.samples / kSamplesOfAFragment + 1, std::size_t{kMostFragments}));
  plan.weights.clear();
  glm::dvec3 epipole(0, 1, 0);
  const int wanted = std::min(at_once, worth);
  if (wanted < 2) {
    plan.fragments[0] = {};
    return 1;
  }
  const glm::vec2 corner(desired.width, desired.height);
  forEachImage([&](const ImageWarp& image) {
    epipole = image.transform.per_disparity;  // that of the last and nearest image
    for (std::size_t i = 0; i < image.boxes.size(); ++i) {
      const ScreenBox& box = image.boxes[i];
      if (box.empty()) continue;
      const glm::vec2 low = glm::clamp(glm::vec2(box.left, box.top), glm::vec2(0), corner);
      const glm::vec2 high = glm::clamp(glm::vec2(box.right, box.bottom), glm::vec2(0), corner);
      plan.weights.push_back({0.5f * (low + high), static_cast<float>(image.ldi.tiles[i].count)});
    }
  });
  return cutIntoFragments(epipole, plan.weights, wanted, plan.fragments);
}

void RegionWarp::warpInto(const WarpWindow& window, const Fragment& fragment) const noexcept {
  forEachImage([&](const ImageWarp& image) {
    visitInSheets(image.ldi, image.order, [&](const LdiTile& tile) {
      const ScreenBox& box = image.boxes[static_cast<std::size_t>(&tile - image.ldi.tiles.data())];
      if (box.empty() || !fragment.mayTouch(box)) return;
      const auto samples = std::span(image.ldi.samples).subspan(tile.first, tile.count);
      const TileTransform transform = tileTransform(image.transform, tile);
      if (options.splat < Splat::kSized) {
        paintSplats(options.splat, transform, samples, window);
      } else {
        layPatches(options.splat, transform, samples, window);
      }
    });
  });
}

void RegionWarp::warpFragment(const Fragment& fragment, WarpCounts& sum) const noexcept {
  const bool with_depth = keepsDepth(options.splat);
  const int beside = with_depth ? 1 : 0;  // pixels at whose depth a crack's pixel looks
  glm::ivec4 box(desired.width, desired.height, 0, 0);
  for (int y = rows.top; y < rows.bottom; ++y) {
    const glm::ivec2 columns = fragment.columns(y, plan.spans[static_cast<std::size_t>(y)]);
    if (columns.x >= columns.y) continue;
    box = {std::min(box.x, columns.x - beside), std::min(box.y, y - beside),
           std::max(box.z, columns.y + beside), std::max(box.w, y + 1 + beside)};
  }
  if (box.x >= box.z) return;
  const glm::ivec2 size(desired.width, desired.height);
  box = {glm::max(glm::ivec2(box), glm::ivec2(0)), glm::min(glm::ivec2(box.z, box.w), size)};
  const Pool<WorkingPicture>::Lease picture(target.scratch().pictures);
  const WarpWindow window = picture->window(box, desired.width, desired.height, options.splat);
  warpInto(window, fragment);
  const RegionPart part{plan.spans, rows.top, rows.bottom, fragment};
  (with_depth ? resolveMeans : resolvePainted)(part, window, target.color, sum);
}

}  // namespace

WarpBuffer::WarpBuffer(std::shared_ptr<WarpScratch> scratch)
    : scratch_(scratch ? std::move(scratch) : std::make_shared<WarpScratch>()) {}

void WarpBuffer::resize(int width, int height) {
  color.width = width;
  color.height = height;
  color.rgba.assign(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
}

WarpCounts warpImages(std::span<const Ldi* const> images, const PlanarCamera& desired,
                      std::span<const glm::vec2> polygon, WarpBuffer& target,
                      const WarpOptions& options) noexcept {
  assert(desired.width == target.color.width && desired.height == target.color.height);
  const Pool<WarpPlan>::Lease plan(target.scratch().plans);
  RegionWarp warp{desired, images, target, options, *plan, {}, {}};
  warp.clip(polygon);
  const std::size_t fragments = warp.cut();
  std::array<WarpCounts, kMostFragments> parts;
  const auto warpPart = [&](std::size_t i) {
    parts[i] = {};
    warp.warpFragment(plan->fragments[i], parts[i]);
  };
  if (fragments == 1) {
    warpPart(0);
  } else {
    tbb::parallel_for(std::size_t{0}, fragments, warpPart, tbb::simple_partitioner());
  }
  for (std::size_t i = 0; i < fragments; ++i) {
    warp.counts.pixels += parts[i].pixels;
    warp.counts.pixels_uncovered += parts[i].pixels_uncovered;
    warp.counts.pixels_bridged += parts[i].pixels_bridged;
  }
  return warp.counts;
}

WarpCounts warpLdi(const Ldi& ldi, const PlanarCamera& desired, std::span<const glm::vec2> region,
                   WarpBuffer& target, const WarpOptions& options) noexcept {
  const Ldi* const image = &ldi;
  return warpImages({&image, 1}, desired, region, target, options);
}

}  // namespace enfilade
