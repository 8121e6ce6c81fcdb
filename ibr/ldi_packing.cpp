#include "ibr/ldi_packing.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace enfilade {

glm::ivec2 tileRange(int pixels, float half_width) noexcept {
  const auto tile_of = [](float pixel) { return static_cast<int>(std::floor(pixel / kLdiTile)); };
  const float half = 0.5f * static_cast<float>(pixels);
  const int first = tile_of(half - half_width * half);
  return {first, tile_of(half + half_width * half) - first + 1};
}

void LdiPacking::add(int x, int y, const std::vector<LooseSample>& samples) {
  if (samples.empty()) return;
  // By place, then as they come: one number to compare.
  order_.clear();
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const LooseSample& s = samples[i];
    order_.push_back(std::uint64_t{packPlace(s.x, s.y, s.disparity)} << 32 | i);
  }
  std::sort(order_.begin(), order_.end());
  for (const std::uint64_t next : order_) {
    const LooseSample& s = samples[next & 0xffffffffu];
    ldi_.samples.push_back(
        {s.r, s.g, s.b, packFootprint(s.across, s.down), static_cast<std::uint32_t>(next >> 32)});
  }
  LdiTile tile;
  tile.count = static_cast<std::uint32_t>(samples.size());
  ldi_.tiles.push_back(tile);
  corners_.push_back({x, y});
}

Ldi LdiPacking::finish() {
  glm::ivec2 least(0);
  glm::ivec2 beyond = (glm::ivec2(central_.width, central_.height) + kLdiTile - 1) / kLdiTile;
  for (const Corner& tile : corners_) {
    least = glm::min(least, glm::ivec2(tile.x, tile.y));
    beyond = glm::max(beyond, glm::ivec2(tile.x + 1, tile.y + 1));
  }
  for (std::size_t i = 0; i < corners_.size(); ++i) {
    ldi_.tiles[i].x = static_cast<std::uint16_t>(corners_[i].x - least.x);
    ldi_.tiles[i].y = static_cast<std::uint16_t>(corners_[i].y - least.y);
  }
  const glm::ivec2 corner = least * kLdiTile;
  const glm::ivec2 size = (beyond - least) * kLdiTile;
  ldi_.camera = withWindow(central_, corner.x, corner.y, size.x, size.y);
  indexTiles(ldi_);
  return std::move(ldi_);
}

}  // namespace enfilade
