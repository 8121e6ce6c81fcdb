#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "ibr/planar_camera.h"

namespace enfilade {

/// Pixels of a tile of a layered depth image, across and down.
inline constexpr int kLdiTile = 16;

/// One sample of a layered depth image: 8 bytes.
/// `place`, from the high bits: disparity 18, y in the tile 7, x in the tile 7.  x and y in eighths
/// of a pixel, so that a pixel's centre is a multiple; δ = (stored + 1) / 2¹⁸.  So samples of a
/// tile compare by `place` as they do by disparity.
struct LdiSample {
  std::uint8_t r = 0, g = 0, b = 0;
  std::uint8_t footprint = 0;  ///< size, see packFootprint()
  std::uint32_t place = 0;
};
static_assert(sizeof(LdiSample) == 8);

inline constexpr int kDisparityBits = 18;
inline constexpr int kPlaceBits = 7;         ///< of x and of y in a tile
inline constexpr float kPlaceStep = 0.125f;  ///< [pixels]

inline float disparityOf(const LdiSample& s) noexcept {
  return static_cast<float>(static_cast<int>(s.place >> (2 * kPlaceBits)) + 1) *
         (1.0f / (1 << kDisparityBits));
}
inline float xInTile(const LdiSample& s) noexcept {
  return static_cast<float>(static_cast<int>(s.place & 127u)) * kPlaceStep;
}
inline float yInTile(const LdiSample& s) noexcept {
  return static_cast<float>(static_cast<int>((s.place >> kPlaceBits) & 127u)) * kPlaceStep;
}

/// The nearest place that can be stored; x and y stay in their pixel.
/// `x`, `y`: pixels from the tile's corner, 0 ≤ x, y < kLdiTile.  Disparity is clamped to what can
/// be stored.
std::uint32_t packPlace(float x, float y, float disparity) noexcept;

/// The size of a sample's patch of surface in the LDI's pixels, as two 4-bit codes (across high,
/// down low): 2^((code − 4) / 2), that is 0.25 … 45; the next larger one that can be stored.
std::uint8_t packFootprint(float across, float down) noexcept;
float footprintSize(unsigned code) noexcept;  ///< of one 4-bit code [pixels]

/// A square of kLdiTile × kLdiTile pixels that holds samples.
struct LdiTile {
  std::uint16_t x = 0, y = 0;  ///< the tile's corner is pixel (x, y) · kLdiTile
  std::uint32_t first = 0;     ///< samples [first, first + count)
  std::uint32_t count = 0;     ///< > 0
  float least_disparity = 0;
  float greatest_disparity = 0;
  float greatest_footprint = 0;  ///< [pixels] across or down, of any sample
};

/// What a column of tiles holds.
struct LdiColumn {
  int first_row = 0, last_row = -1;  ///< of tiles; none: last < first
  float least_disparity = 1;
  float greatest_disparity = 0;
  float greatest_footprint = 0;  ///< [pixels]

  void include(const LdiColumn& other) noexcept;
};

/// A layered depth image: any number of samples a pixel, along the rays of one planar camera.
/// Only tiles with samples are kept, so that a wide window costs nothing.  Tiles by row, then by
/// column.  A tile's samples by increasing disparity (farthest first; ties by place), which is back
/// to front for every eye on the near side of the image plane.
/// Source: Shade, Gortler, He & Szeliski, Layered Depth Images, 1998; Rafferty et al. 1998,
/// sec. 3.2.
struct Ldi {
  PlanarCamera camera;
  std::vector<LdiTile> tiles;
  std::vector<std::uint32_t> row_tiles;     ///< rows of tiles + 1: row r is tiles [row_tiles[r],
                                            ///< row_tiles[r + 1])
  std::vector<LdiColumn> columns;           ///< one a column of tiles
  std::vector<std::uint32_t> column_first;  ///< columns + 1, into column_order
  std::vector<std::uint32_t> column_order;  ///< the tiles by column
  std::vector<LdiSample> samples;

  /// The tiles of a column of tiles, from top to bottom.
  std::span<const std::uint32_t> columnTiles(std::size_t column) const noexcept {
    return std::span(column_order)
        .subspan(column_first[column], column_first[column + 1] - column_first[column]);
  }
};

/// The bytes that an image with a window of `width` × `height` pixels takes in memory.
std::size_t ldiBytes(int width, int height, std::size_t tiles, std::size_t samples) noexcept;
inline std::size_t ldiBytes(const Ldi& ldi) noexcept {
  return ldiBytes(ldi.camera.width, ldi.camera.height, ldi.tiles.size(), ldi.samples.size());
}

/// The samples of pixel (x, y), nearest first: layer one, two …
std::vector<LdiSample> layersAt(const Ldi& ldi, int x, int y);

/// How many samples lie in layer one, two …
std::vector<std::size_t> samplesPerLayer(const Ldi& ldi);

/// Sets every tile's and column's bounds and the indices, from the tiles' places, counts and
/// samples.
void indexTiles(Ldi& ldi);

}  // namespace enfilade
