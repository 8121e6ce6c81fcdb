#pragma once

#include "ibr/convex_region.h"
#include "ibr/fragments.h"
#include "ibr/pool.h"
#include "ibr/warp.h"
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

/// What is found out about a warp into one region before it begins.
struct WarpPlan {
  std::vector<ScreenBox> boxes;     ///< one a tile, image after image; empty: left out
  std::vector<TileWeight> weights;  ///< of the tiles that are not left out
  std::vector<glm::ivec2> spans;    ///< the region's columns, one a row
  RowRange rows;                    ///< of the region
  std::array<Fragment, kMostFragments> fragments;
  std::array<WarpCounts, kMostFragments> counts;  ///< of each fragment's pixels
  std::size_t fragment_count = 0;
};

/// The work of some warps at once: one plan a job, and parts of the work at hand.
struct WarpAgenda {
  struct Part {
    std::size_t job;
    std::size_t first, beyond;  ///< tiles, or one fragment
  };
  std::vector<WarpPlan> plans;
  std::vector<Part> parts;
};

/// Working memory for warps, as much as has been needed at once.
struct WarpScratch {
  Pool<WarpAgenda> agendas;
  Pool<WorkingPicture> pictures;
};

}  // namespace enfilade
