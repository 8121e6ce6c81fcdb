#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "ibr/warp_positions.h"

namespace enfilade {

/// Rows of a picture, from top to bottom.
struct RowsReached {
  float top = 0;
  float bottom = -1;

  bool empty() const noexcept { return !(top <= bottom); }
};

/// Tells which tiles of a layered depth image may fall into a region of the desired picture.
/// Source: Popescu, Lastra, Aliaga & Oliveira, Efficient Warping for Architectural Walkthroughs
/// Using Layered Depth Images, 1998, which clips columns by their least and greatest disparity.
class TileClip {
 public:
  /// `region`: a convex polygon in pixels, any winding.
  explicit TileClip(std::span<const glm::vec2> region) noexcept;

  /// The rows [pixels] that samples of the tile may touch, if they may touch the region at all;
  /// empty() if not.  Conservative: never too few.
  RowsReached rowsReached(const LdiTile& tile, const TileTransform& transform) const noexcept;

 private:
  static constexpr std::size_t kMostEdges = 16;

  std::array<glm::vec3, kMostEdges + 4> edges_{};  ///< n·p + d, inside ≥ 0; |n| = 1
  std::size_t count_ = 0;
};

}  // namespace enfilade
