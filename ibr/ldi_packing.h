#pragma once

#include <cstdint>
#include <vector>

#include "ibr/ldi.h"

namespace enfilade {

/// A sample of a tile before it is stored.
struct LooseSample {
  float x = 0, y = 0;          ///< pixels from the tile's corner
  float disparity = 0;         ///< in the central view
  float across = 1, down = 1;  ///< size of its patch of surface in the central view [pixels]
  std::uint8_t r = 0, g = 0, b = 0;
};

/// First tile and number of tiles for `half_width` times the half of `pixels` around its middle.
glm::ivec2 tileRange(int pixels, float half_width) noexcept;

/// Puts tiles together as a layered depth image.
class LdiPacking {
 public:
  explicit LdiPacking(const PlanarCamera& central) : central_(central) {}

  /// Appends tile (x, y), counted from the central image's corner; by row, then by column.  One
  /// without samples is left out.  Samples are put into the order of an Ldi; those with the same
  /// place stay in theirs.
  void add(int x, int y, const std::vector<LooseSample>& samples);

  /// The layered depth image; its window is the central image and all tiles.
  Ldi finish();

 private:
  struct Corner {
    int x, y;
  };
  PlanarCamera central_;
  std::vector<Corner> corners_;       ///< one a tile of ldi_
  std::vector<std::uint64_t> order_;  ///< kept for its memory
  Ldi ldi_;
};

}  // namespace enfilade
