#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "ibr/warp_positions.h"

namespace enfilade {

/// Tells which tiles of a layered depth image may fall into a region of the desired picture.
/// Source: Popescu, Lastra, Aliaga & Oliveira, Efficient Warping for Architectural Walkthroughs
/// Using Layered Depth Images, 1998, which clips columns by their least and greatest disparity.
class TileClip {
 public:
  /// `region`: a convex polygon in pixels, any winding.
  explicit TileClip(std::span<const glm::vec2> region) noexcept;

  /// Whether a sample of the tile may touch a pixel of the region.  Conservative: never no where
  /// one does.
  bool mayReach(const LdiTile& tile, const TileTransform& transform) const noexcept;

 private:
  static constexpr std::size_t kMostEdges = 16;

  std::array<glm::vec3, kMostEdges + 4> edges_{};  ///< n·p + d, inside ≥ 0; |n| = 1
  std::size_t count_ = 0;
};

}  // namespace enfilade
