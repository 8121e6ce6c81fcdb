#include "ibr/ldi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace enfilade {

std::uint32_t packPlace(float x, float y, float disparity) noexcept {
  const auto coordinate = [](float value) {
    const float pixel = std::clamp(std::floor(value), 0.0f, kLdiTile - 1.0f);
    const float eighths = std::clamp(std::round((value - pixel) / kPlaceStep), 0.0f, 7.0f);
    return static_cast<std::uint32_t>(pixel) * 8u + static_cast<std::uint32_t>(eighths);
  };
  constexpr float kSteps = 1 << kDisparityBits;
  const float stored = std::clamp(std::round(disparity * kSteps) - 1.0f, 0.0f, kSteps - 1.0f);
  return static_cast<std::uint32_t>(stored) << (2 * kPlaceBits) | coordinate(y) << kPlaceBits |
         coordinate(x);
}

std::uint8_t packFootprint(float across, float down) noexcept {
  // The greatest size of each code but the last.  The small allowance keeps a size of exactly one
  // pixel at its own code.
  static const std::array<float, 15> greatest = [] {
    std::array<float, 15> table{};
    for (int i = 0; i < 15; ++i) {
      table[static_cast<std::size_t>(i)] = std::exp2(0.5f * (static_cast<float>(i - 4) + 0.01f));
    }
    return table;
  }();
  const auto code = [](float size) {
    unsigned smaller = 0;
    for (const float most : greatest) smaller += size > most;
    return smaller;
  };
  return static_cast<std::uint8_t>(code(across) << 4 | code(down));
}

float footprintSize(unsigned code) noexcept {
  static const std::array<float, 16> sizes = [] {
    std::array<float, 16> table{};
    for (int i = 0; i < 16; ++i) {
      table[static_cast<std::size_t>(i)] = std::exp2(0.5f * static_cast<float>(i - 4));
    }
    return table;
  }();
  return sizes[code & 15u];
}

std::vector<LdiSample> layersAt(const Ldi& ldi, int x, int y) {
  const int tile_x = x / kLdiTile;
  const int tile_y = y / kLdiTile;
  const auto tile = std::lower_bound(ldi.tiles.begin(), ldi.tiles.end(), std::pair(tile_y, tile_x),
                                     [](const LdiTile& t, const std::pair<int, int>& at) {
                                       return std::pair<int, int>(t.y, t.x) < at;
                                     });
  std::vector<LdiSample> layers;
  if (tile == ldi.tiles.end() || tile->x != tile_x || tile->y != tile_y) {
    return layers;
  }
  for (const LdiSample& s : std::span(ldi.samples).subspan(tile->first, tile->count)) {
    if (static_cast<int>(xInTile(s)) == x % kLdiTile &&
        static_cast<int>(yInTile(s)) == y % kLdiTile) {
      layers.insert(layers.begin(), s);
    }
  }
  return layers;
}

std::vector<std::size_t> samplesPerLayer(const Ldi& ldi) {
  std::vector<std::size_t> layers;
  for (const LdiTile& tile : ldi.tiles) {
    std::array<std::size_t, kLdiTile * kLdiTile> at_pixel{};
    for (const LdiSample& s : std::span(ldi.samples).subspan(tile.first, tile.count)) {
      const auto pixel =
          static_cast<std::size_t>(yInTile(s)) * kLdiTile + static_cast<std::size_t>(xInTile(s));
      const std::size_t layer = at_pixel[pixel]++;
      layers.resize(std::max(layers.size(), layer + 1));
      ++layers[layer];
    }
  }
  return layers;
}

void LdiColumn::include(const LdiColumn& other) noexcept {
  if (other.last_row < other.first_row) return;
  first_row = last_row < first_row ? other.first_row : std::min(first_row, other.first_row);
  last_row = std::max(last_row, other.last_row);
  least_disparity = std::min(least_disparity, other.least_disparity);
  greatest_disparity = std::max(greatest_disparity, other.greatest_disparity);
  greatest_footprint = std::max(greatest_footprint, other.greatest_footprint);
}

namespace {

void indexColumns(Ldi& ldi) {
  const auto columns = static_cast<std::size_t>((ldi.camera.width + kLdiTile - 1) / kLdiTile);
  ldi.columns.assign(columns, {});
  ldi.column_first.assign(columns + 1, 0);
  for (const LdiTile& tile : ldi.tiles) {
    ldi.columns[tile.x].include(
        {tile.y, tile.y, tile.least_disparity, tile.greatest_disparity, tile.greatest_footprint});
    ++ldi.column_first[std::size_t{tile.x} + 1];
  }
  std::partial_sum(ldi.column_first.begin(), ldi.column_first.end(), ldi.column_first.begin());
  std::vector<std::uint32_t> next(ldi.column_first.begin(), ldi.column_first.end() - 1);
  ldi.column_order.resize(ldi.tiles.size());
  for (std::uint32_t i = 0; i < ldi.tiles.size(); ++i) {
    ldi.column_order[next[ldi.tiles[i].x]++] = i;
  }
}

}  // namespace

std::size_t ldiBytes(int width, int height, std::size_t tiles, std::size_t samples) noexcept {
  const auto rows = static_cast<std::size_t>((height + kLdiTile - 1) / kLdiTile);
  const auto columns = static_cast<std::size_t>((width + kLdiTile - 1) / kLdiTile);
  constexpr std::size_t kIndex = sizeof(std::uint32_t);
  return samples * sizeof(LdiSample) + tiles * (sizeof(LdiTile) + kIndex) + (rows + 1) * kIndex +
         columns * sizeof(LdiColumn) + (columns + 1) * kIndex;
}

void indexTiles(Ldi& ldi) {
  const auto rows = static_cast<std::size_t>((ldi.camera.height + kLdiTile - 1) / kLdiTile);
  ldi.row_tiles.assign(rows + 1, 0);
  std::uint32_t first = 0;
  for (LdiTile& tile : ldi.tiles) {
    tile.first = first;
    first += tile.count;
    ++ldi.row_tiles[std::size_t{tile.y} + 1];
    const auto samples = std::span(ldi.samples).subspan(tile.first, tile.count);
    tile.least_disparity = disparityOf(samples.front());
    tile.greatest_disparity = disparityOf(samples.back());
    unsigned code = 0;
    for (const LdiSample& s : samples) {
      code = std::max({code, unsigned{s.footprint} >> 4, unsigned{s.footprint} & 15u});
    }
    tile.greatest_footprint = footprintSize(code);
  }
  std::partial_sum(ldi.row_tiles.begin(), ldi.row_tiles.end(), ldi.row_tiles.begin());
  indexColumns(ldi);
}

}  // namespace enfilade
