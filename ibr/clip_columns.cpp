#include "ibr/clip_columns.h"

#include <algorithm>

namespace enfilade {
namespace {

struct ColumnClip {
  const Ldi& ldi;
  const WarpTransform& warp;
  const RegionClip& clip;
  std::span<ScreenBox> boxes;

  /// Columns [first, beyond), not none.
  void clipRange(std::size_t first, std::size_t beyond) const noexcept {
    LdiColumn all = ldi.columns[first];
    for (std::size_t c = first + 1; c < beyond; ++c) all.include(ldi.columns[c]);
    if (all.last_row < all.first_row) return;  // no tiles
    LdiTile corner;
    corner.x = static_cast<std::uint16_t>(first);
    corner.y = static_cast<std::uint16_t>(all.first_row);
    const auto side = [](std::size_t tiles) { return static_cast<float>(tiles * kLdiTile); };
    const SampleBox box{0,
                        side(beyond - first),
                        0,
                        side(static_cast<std::size_t>(all.last_row - all.first_row + 1)),
                        all.least_disparity,
                        all.greatest_disparity,
                        all.greatest_footprint};
    const ScreenBox reached = clip.reached(box, tileTransform(warp, corner));
    if (reached.empty()) return;
    if (beyond - first == 1) {
      keep(first, reached);
    } else {
      const std::size_t middle = (first + beyond) / 2;
      clipRange(first, middle);
      clipRange(middle, beyond);
    }
  }

  void keep(std::size_t column, const ScreenBox& reached) const noexcept {
    for (const std::uint32_t tile : ldi.columnTiles(column)) boxes[tile] = reached;
  }
};

}  // namespace

void clipByColumns(const Ldi& ldi, const WarpTransform& warp, const RegionClip& clip,
                   std::span<ScreenBox> boxes) noexcept {
  std::fill(boxes.begin(), boxes.end(), ScreenBox{});
  if (!ldi.columns.empty()) {
    ColumnClip{ldi, warp, clip, boxes}.clipRange(0, ldi.columns.size());
  }
}

}  // namespace enfilade
