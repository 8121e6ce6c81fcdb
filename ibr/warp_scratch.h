#pragma once

#include "ibr/fragments.h"
#include "ibr/pool.h"
#include "ibr/splat.h"
#include "ibr/warp_window.h"

namespace enfilade {

/// A thread's own picture to warp into: what it gets right is copied out, so that no thread ever
/// writes where another one does.
class WorkingPicture {
 public:
  /// A cleared window of a frame of `frame_width` pixels a row: columns [left, right), rows [top,
  /// bottom); with what the splat needs.
  WarpWindow window(const glm::ivec4& left_top_right_bottom, int frame_width, int frame_height,
                    Splat splat);

 private:
  std::vector<std::uint32_t> painted_;
  std::vector<std::uint64_t> sums_;
  std::vector<float> nearest_, closeness_;
};

/// What is found out about a warp before it begins.
struct WarpPlan {
  std::vector<ScreenBox> boxes;     ///< one a tile, image after image; empty: left out
  std::vector<TileWeight> weights;  ///< of the tiles that are not left out
  std::vector<glm::ivec2> spans;    ///< the region's columns, one a row
  std::array<Fragment, kMostFragments> fragments;
};

/// Working memory for warps, as much as has been needed at once.
struct WarpScratch {
  Pool<WarpPlan> plans;
  Pool<WorkingPicture> pictures;
};

}  // namespace enfilade
