// Rafferty, Aliaga, Popescu & Lastra, Images for Accelerating Architectural Walkthroughs, 1998,
// sec. 3.2.
#include "ibr/ldi_builder.h"

#include <algorithm>
#include <cmath>

#include "ibr/ldi_packing.h"
#include "ibr/warped_sample.h"

namespace enfilade {
namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

int tileOf(float pixel) { return static_cast<int>(std::floor(pixel / kLdiTile)); }

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

LdiBuilder::Tile* LdiBuilder::tileAt(float x, float y) {
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
    tiles_.push_back({tile.x, tile.y, {}, {}, {}, kNone});
    tiles_.back().nearest.fill(kNone);
  }
  return &tiles_[index];
}

bool LdiBuilder::meets(const Layer& a, const Layer& b) const noexcept {
  return a.capture != b.capture && std::abs(a.disparity - b.disparity) <= threshold_;
}

void LdiBuilder::Look::coverAlso(const Look& other) noexcept {
  across = std::max(across, std::min(other.across, kLeastCover));
  down = std::max(down, std::min(other.down, kLeastCover));
}

bool LdiBuilder::stays(Tile& tile, std::uint32_t nearest, const Layer& layer,
                       const Look& look) const noexcept {
  for (std::uint32_t i = nearest; i != kNone; i = tile.layers[i].farther) {
    const Layer& there = tile.layers[i];
    const bool central = there.capture == 0 && layer.capture != 0;
    const bool displaces_it = central && layer.disparity > there.disparity;
    const bool loses_to_it = meets(layer, there) && (central || there.area <= layer.area);
    if (displaces_it || loses_to_it) {
      if (loses_to_it) tile.looks[i].coverAlso(look);
      return false;
    }
  }
  return true;
}

void LdiBuilder::removeThoseItMeets(Tile& tile, std::uint32_t& nearest, const Layer& layer,
                                    Look& look) const noexcept {
  for (std::uint32_t* link = &nearest; *link != kNone;) {
    const std::uint32_t i = *link;
    Layer& there = tile.layers[i];
    if (meets(layer, there)) {
      look.coverAlso(tile.looks[i]);
      *link = there.farther;
      there.farther = tile.free;
      tile.free = i;
    } else {
      link = &there.farther;
    }
  }
}

void LdiBuilder::place(Tile& tile, std::uint32_t& nearest, Layer layer, Look look) const {
  removeThoseItMeets(tile, nearest, layer, look);
  std::uint32_t* link = &nearest;
  while (*link != kNone && tile.layers[*link].disparity >= layer.disparity) {
    link = &tile.layers[*link].farther;
  }
  layer.farther = *link;
  if (tile.free != kNone) {
    const std::uint32_t i = tile.free;
    tile.free = tile.layers[i].farther;
    *link = i;
    tile.layers[i] = layer;
    tile.looks[i] = look;
  } else {
    *link = static_cast<std::uint32_t>(tile.layers.size());  // before `link` moves with the layers
    tile.layers.push_back(layer);
    tile.looks.push_back(look);
  }
}

void LdiBuilder::insert(const CaptureSamples& capture) {
  const WarpTransform warp = warpTransform(capture.camera, central_);
  for (const CaptureSample& s : capture.samples) {
    const WarpedSample w = warpSample(warp, s);
    if (!(w.disparity > 0.0f)) continue;
    Tile* const tile = tileAt(w.x, w.y);
    if (tile == nullptr) continue;
    // Less than kLdiTile, which w.x − corner may round to.
    const glm::ivec2 corner = kLdiTile * glm::ivec2(tile->x, tile->y);
    const int column = static_cast<int>(std::floor(w.x)) - corner.x;
    const int row = static_cast<int>(std::floor(w.y)) - corner.y;
    std::uint32_t& nearest = tile->nearest[static_cast<std::size_t>(row * kLdiTile + column)];
    const Layer layer{w.disparity, s.doubt * static_cast<float>(patchArea(capture.camera, s)),
                      captures_, kNone};
    const Look look{w.x - static_cast<float>(corner.x),
                    w.y - static_cast<float>(corner.y),
                    w.across,
                    w.down,
                    s.r,
                    s.g,
                    s.b};
    if (stays(*tile, nearest, layer, look)) place(*tile, nearest, layer, look);
  }
  ++captures_;
}

Ldi LdiBuilder::finish() const {
  LdiPacking packing(central_);
  std::vector<LooseSample> samples;
  for (const std::uint32_t index : tile_at_) {  // by row, then by column
    if (index == kNone) continue;
    const Tile& tile = tiles_[index];
    samples.clear();
    for (const std::uint32_t nearest : tile.nearest) {
      for (std::uint32_t i = nearest; i != kNone; i = tile.layers[i].farther) {
        const Look& look = tile.looks[i];
        samples.push_back({look.x, look.y, tile.layers[i].disparity, look.across, look.down, look.r,
                           look.g, look.b});
      }
    }
    packing.add(tile.x, tile.y, samples);
  }
  return packing.finish();
}

}  // namespace enfilade
