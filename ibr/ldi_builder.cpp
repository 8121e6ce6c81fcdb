// Rafferty, Aliaga, Popescu & Lastra, Images for Accelerating Architectural Walkthroughs, 1998,
// sec. 3.2.
#include "ibr/ldi_builder.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

/// A sample as the central view sees it.
struct WarpedSample {
  glm::dvec2 at;         ///< pixels
  double disparity = 0;  ///< ≤ 0: behind the central viewpoint
  glm::dvec2 size;       ///< the box of its patch of surface [pixels]
};

WarpedSample warpSample(const WarpTransform& warp, const CaptureSample& s) {
  const auto disparity = static_cast<double>(s.disparity);
  const glm::dvec3 h =
      warp.homogeneous(static_cast<double>(s.u), static_cast<double>(s.v), disparity);
  WarpedSample w;
  w.at = glm::dvec2(h) / h.z;
  w.disparity = disparity / h.z;

  // Along the surface the disparity changes with u and v.
  const glm::dvec3 per_u =
      warp.to_from_pixel[0] + static_cast<double>(s.slope_u) * warp.per_disparity;
  const glm::dvec3 per_v =
      warp.to_from_pixel[1] + static_cast<double>(s.slope_v) * warp.per_disparity;
  const glm::dvec2 side_u = (glm::dvec2(per_u) - w.at * per_u.z) / h.z;
  const glm::dvec2 side_v = (glm::dvec2(per_v) - w.at * per_v.z) / h.z;
  w.size = static_cast<double>(s.width) * glm::abs(side_u) +
           static_cast<double>(s.height) * glm::abs(side_v);
  return w;
}

int tileOf(float pixel) { return static_cast<int>(std::floor(pixel / kLdiTile)); }

/// First tile and number of tiles for `half_width` times the half of `pixels` around its middle.
glm::ivec2 tileRange(int pixels, float half_width) {
  const float half = 0.5f * static_cast<float>(pixels);
  const int first = tileOf(half - half_width * half);
  return {first, tileOf(half + half_width * half) - first + 1};
}

}  // namespace

float disparityThreshold(const PlanarCamera& central, float depth_threshold_pixels) noexcept {
  const double pixel =
      std::max(glm::length(central.world_from_pixel[0]), glm::length(central.world_from_pixel[1]));
  return static_cast<float>(static_cast<double>(depth_threshold_pixels) * pixel /
                            imagePlaneDistance(central));
}

LdiBuilder::LdiBuilder(const PlanarCamera& central, const LdiRules& rules)
    : central_(central), threshold_(disparityThreshold(central, rules.depth_threshold)) {
  const glm::ivec2 x = tileRange(central.width, rules.half_width);
  const glm::ivec2 y = tileRange(central.height, rules.half_width);
  least_ = {x[0], y[0]};
  tiles_across_ = {x[1], y[1]};
  tile_at_.assign(static_cast<std::size_t>(x[1]) * static_cast<std::size_t>(y[1]), kNone);
}

std::uint32_t* LdiBuilder::headAt(float x, float y) {
  constexpr float kBeyondAnyWindow = 1e7f;
  if (!(std::abs(x) < kBeyondAnyWindow && std::abs(y) < kBeyondAnyWindow)) {
    return nullptr;
  }
  const glm::ivec2 tile(tileOf(x), tileOf(y));
  const glm::ivec2 cell = tile - least_;
  if (glm::any(glm::lessThan(cell, glm::ivec2(0))) ||
      glm::any(glm::greaterThanEqual(cell, tiles_across_))) {
    return nullptr;
  }
  std::uint32_t& index =
      tile_at_[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(tiles_across_.x) +
               static_cast<std::size_t>(cell.x)];
  if (index == kNone) {
    index = static_cast<std::uint32_t>(tiles_.size());
    tiles_.push_back({tile.x, tile.y, std::vector<std::uint32_t>(kLdiTile * kLdiTile, kNone)});
  }
  const int column = static_cast<int>(std::floor(x)) - tile.x * kLdiTile;
  const int row = static_cast<int>(std::floor(y)) - tile.y * kLdiTile;
  return &tiles_[index].heads[static_cast<std::size_t>(row * kLdiTile + column)];
}

bool LdiBuilder::meets(const Node& a, const Node& b) const noexcept {
  return a.capture != b.capture && std::abs(a.disparity - b.disparity) <= threshold_;
}

void LdiBuilder::place(const Node& node) {
  std::uint32_t* const head = headAt(node.x, node.y);
  if (head == nullptr) {
    return;
  }
  for (std::uint32_t i = *head; i != kNone; i = nodes_[i].next) {
    const Node& there = nodes_[i];
    const bool central = there.capture == 0 && node.capture != 0;
    const bool displaces_it = central && node.disparity > there.disparity;
    const bool loses_to_it = meets(node, there) && (central || there.area <= node.area);
    if (displaces_it || loses_to_it) {
      return;
    }
  }
  for (std::uint32_t* link = head; *link != kNone;) {
    if (meets(node, nodes_[*link])) {
      *link = nodes_[*link].next;
    } else {
      link = &nodes_[*link].next;
    }
  }
  std::uint32_t* link = head;
  while (*link != kNone && nodes_[*link].disparity >= node.disparity) {
    link = &nodes_[*link].next;
  }
  const std::uint32_t farther = *link;
  *link = static_cast<std::uint32_t>(nodes_.size());  // `link` may point into nodes_
  nodes_.push_back(node);
  nodes_.back().next = farther;
}

void LdiBuilder::insert(const CaptureSamples& capture) {
  const WarpTransform warp = warpTransform(capture.camera, central_);
  nodes_.reserve(nodes_.size() + capture.samples.size());
  for (const CaptureSample& s : capture.samples) {
    const WarpedSample w = warpSample(warp, s);
    if (w.disparity > 0.0) {
      place(
          {static_cast<float>(w.at.x), static_cast<float>(w.at.y), static_cast<float>(w.disparity),
           s.doubt * static_cast<float>(patchArea(capture.camera, s)), static_cast<float>(w.size.x),
           static_cast<float>(w.size.y), s.r, s.g, s.b, captures_, kNone});
    }
  }
  ++captures_;
}

std::vector<const LdiBuilder::Tile*> LdiBuilder::tilesInUse() const {
  std::vector<const Tile*> tiles;
  for (const std::uint32_t index : tile_at_) {  // by row, then by column
    if (index != kNone && std::any_of(tiles_[index].heads.begin(), tiles_[index].heads.end(),
                                      [](std::uint32_t head) { return head != kNone; })) {
      tiles.push_back(&tiles_[index]);
    }
  }
  return tiles;
}

void LdiBuilder::appendSamples(const Tile& tile, Ldi& ldi) const {
  const auto first = static_cast<std::ptrdiff_t>(ldi.samples.size());
  for (const std::uint32_t head : tile.heads) {
    for (std::uint32_t i = head; i != kNone; i = nodes_[i].next) {
      const Node& node = nodes_[i];
      const float x = node.x - static_cast<float>(tile.x * kLdiTile);
      const float y = node.y - static_cast<float>(tile.y * kLdiTile);
      ldi.samples.push_back({node.r, node.g, node.b, packFootprint(node.across, node.down),
                             packPlace(x, y, node.disparity)});
    }
  }
  std::stable_sort(ldi.samples.begin() + first, ldi.samples.end(),
                   [](const LdiSample& a, const LdiSample& b) { return a.place < b.place; });
}

Ldi LdiBuilder::finish() const {
  // The window: the central image and all tiles in use.
  const std::vector<const Tile*> tiles = tilesInUse();
  glm::ivec2 least(0);
  glm::ivec2 beyond = (glm::ivec2(central_.width, central_.height) + kLdiTile - 1) / kLdiTile;
  for (const Tile* tile : tiles) {
    least = glm::min(least, glm::ivec2(tile->x, tile->y));
    beyond = glm::max(beyond, glm::ivec2(tile->x + 1, tile->y + 1));
  }
  const glm::ivec2 corner = least * kLdiTile;
  const glm::ivec2 size = (beyond - least) * kLdiTile;

  Ldi ldi;
  ldi.camera = withWindow(central_, corner.x, corner.y, size.x, size.y);
  for (const Tile* tile : tiles) {
    LdiTile packed;
    const std::size_t first = ldi.samples.size();
    appendSamples(*tile, ldi);
    packed.x = static_cast<std::uint16_t>(tile->x - least.x);
    packed.y = static_cast<std::uint16_t>(tile->y - least.y);
    packed.count = static_cast<std::uint32_t>(ldi.samples.size() - first);
    ldi.tiles.push_back(packed);
  }
  indexTiles(ldi);
  return ldi;
}

}  // namespace enfilade
