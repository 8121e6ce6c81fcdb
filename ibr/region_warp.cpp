#include "ibr/region_warp.h"

#include <algorithm>
#include <cassert>

#include "ibr/clip_columns.h"
#include "ibr/lay_patches.h"
#include "ibr/paint_splats.h"
#include "ibr/resolve.h"

namespace enfilade {
namespace {

ImageWarp imageWarp(const Ldi& ldi, const PlanarCamera& desired, std::span<ScreenBox> boxes) {
  return {ldi, warpTransform(ldi.camera, desired), sheetOrder(ldi.camera, desired.center), boxes};
}

constexpr ScreenBox kEverywhere{-1e30f, -1e30f, 1e30f, 1e30f};

/// Sets the boxes of tiles [first, beyond) of an image.
void clipImage(const ImageWarp& image, const RegionClip& region, Clip clip, std::size_t first,
               std::size_t beyond) noexcept {
  switch (clip) {
    case Clip::kNothing:
      std::fill(image.boxes.begin(), image.boxes.end(), kEverywhere);
      break;
    case Clip::kColumns:
      clipByColumns(image.ldi, image.transform, region, image.boxes);
      break;
    case Clip::kTiles:
      for (std::size_t i = first; i < beyond; ++i) {
        const LdiTile& tile = image.ldi.tiles[i];
        image.boxes[i] = region.reached(boxOf(tile), tileTransform(image.transform, tile));
      }
  }
}

}  // namespace

/// Calls visit(image, first), where first is the number of its first tile.
template <class Visit>
void RegionWarp::forEachImage(Visit&& visit) const noexcept {
  std::size_t first = 0;
  for (const Ldi* ldi : job.images) {
    visit(imageWarp(*ldi, desired, std::span(plan.boxes).subspan(first, ldi->tiles.size())), first);
    first += ldi->tiles.size();
  }
}

void RegionWarp::begin() const noexcept {
  assert(desired.width == job.target->color.width && desired.height == job.target->color.height);
  std::size_t tiles = 0;
  for (const Ldi* ldi : job.images) tiles += ldi->tiles.size();
  plan.boxes.resize(tiles);
  const auto height = static_cast<std::size_t>(desired.height);
  if (plan.spans.size() < height) plan.spans.resize(height);
  plan.rows = fillConvexPolygon(job.region, desired.width, desired.height, plan.spans);
}

void RegionWarp::clipTiles(std::size_t first, std::size_t beyond) const noexcept {
  const RegionClip region(job.region, options.splat);
  forEachImage([&](const ImageWarp& image, std::size_t number) {
    const std::size_t end = number + image.boxes.size();
    const std::size_t from = std::clamp(first, number, end) - number;
    const std::size_t to = std::clamp(beyond, number, end) - number;
    if (from < to) clipImage(image, region, options.clip, from, to);
  });
}

void RegionWarp::countSamples() const noexcept {
  job.counts = {};
  forEachImage([&](const ImageWarp& image, std::size_t) {
    for (std::size_t i = 0; i < image.boxes.size(); ++i) {
      const std::size_t count = image.ldi.tiles[i].count;
      (image.boxes[i].empty() ? job.counts.samples_clipped : job.counts.samples) += count;
    }
  });
}

void RegionWarp::cut(std::size_t wanted) const noexcept {
  if (wanted < 2) {
    plan.fragments[0] = {};
    plan.fragment_count = 1;
    return;
  }
  plan.weights.clear();
  glm::dvec3 epipole(0, 1, 0);
  const glm::vec2 corner(desired.width, desired.height);
  forEachImage([&](const ImageWarp& image, std::size_t) {
    epipole = image.transform.per_disparity;  // that of the last and nearest image
    for (std::size_t i = 0; i < image.boxes.size(); ++i) {
      const ScreenBox& box = image.boxes[i];
      if (box.empty()) continue;
      const glm::vec2 low = glm::clamp(glm::vec2(box.left, box.top), glm::vec2(0), corner);
      const glm::vec2 high = glm::clamp(glm::vec2(box.right, box.bottom), glm::vec2(0), corner);
      plan.weights.push_back({0.5f * (low + high), static_cast<float>(image.ldi.tiles[i].count)});
    }
  });
  plan.fragment_count =
      cutIntoFragments(epipole, plan.weights, static_cast<int>(wanted), plan.fragments);
}

void RegionWarp::warpInto(const WarpWindow& window, const Fragment& fragment) const noexcept {
  forEachImage([&](const ImageWarp& image, std::size_t) {
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

glm::ivec4 RegionWarp::windowOf(const Fragment& fragment) const noexcept {
  const int beside = keepsDepth(options.splat) ? 1 : 0;  // at whose depth a crack's pixel looks
  glm::ivec4 box(desired.width, desired.height, 0, 0);
  for (int y = plan.rows.top; y < plan.rows.bottom; ++y) {
    const glm::ivec2 columns = fragment.columns(y, plan.spans[static_cast<std::size_t>(y)]);
    if (columns.x >= columns.y) continue;
    box = {std::min(box.x, columns.x - beside), std::min(box.y, y - beside),
           std::max(box.z, columns.y + beside), std::max(box.w, y + 1 + beside)};
  }
  const glm::ivec2 size(desired.width, desired.height);
  return {glm::max(glm::ivec2(box), glm::ivec2(0)), glm::min(glm::ivec2(box.z, box.w), size)};
}

void RegionWarp::warpFragment(std::size_t number) const noexcept {
  const Fragment& fragment = plan.fragments[number];
  WarpCounts& counts = plan.counts[number];
  counts = {};
  const glm::ivec4 box = windowOf(fragment);
  if (box.x >= box.z) return;
  const Pool<WorkingPicture>::Lease picture(job.target->scratch().pictures);
  const WarpWindow window = picture->window(box, desired.width, desired.height, options.splat);
  warpInto(window, fragment);
  const RegionPart part{plan.spans, plan.rows.top, plan.rows.bottom, fragment};
  (keepsDepth(options.splat) ? resolveMeans : resolvePainted)(part, window, job.target->color,
                                                              counts);
}

void RegionWarp::countPixels() const noexcept {
  for (std::size_t i = 0; i < plan.fragment_count; ++i) job.counts += plan.counts[i];
}

}  // namespace enfilade
