#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>

#include "ibr/splat.h"
#include "ibr/warp_positions.h"

namespace enfilade {

/// A box of the desired picture [pixels].
struct ScreenBox {
  float left = 0, top = 0;
  float right = -1, bottom = -1;

  bool empty() const noexcept { return !(left <= right && top <= bottom); }
};

/// A box that holds samples: pixels from a transform's origin, disparities, and the largest
/// footprint, across or down.
struct SampleBox {
  float least_u = 0, greatest_u = 0;
  float least_v = 0, greatest_v = 0;
  float least_disparity = 0, greatest_disparity = 0;
  float greatest_footprint = 0;  ///< [pixels]
};

/// The box of a tile's samples, from the tile's corner.
inline SampleBox boxOf(const LdiTile& tile) noexcept {
  constexpr auto kSide = static_cast<float>(kLdiTile);
  return {
      0, kSide, 0, kSide, tile.least_disparity, tile.greatest_disparity, tile.greatest_footprint};
}

/// Tells which boxes of samples may fall into a region of the desired picture.
/// Source: Popescu, Lastra, Aliaga & Oliveira, Efficient Warping for Architectural Walkthroughs
/// Using Layered Depth Images, 1998.
class RegionClip {
 public:
  /// `region`: a convex polygon in pixels, any winding.
  RegionClip(std::span<const glm::vec2> region, Splat splat) noexcept;

  /// Where the splats of the box's samples may fall, if they may touch the region at all; empty()
  /// if not.  Conservative: never too small.
  ScreenBox reached(const SampleBox& box, const TileTransform& transform) const noexcept;

 private:
  static constexpr std::size_t kMostEdges = 16;

  Splat splat_;
  std::array<glm::vec3, kMostEdges + 4> edges_{};  ///< n·p + d, inside ≥ 0; |n| = 1
  std::size_t count_ = 0;
};

}  // namespace enfilade
