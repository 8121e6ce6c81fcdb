#pragma once

#include "ibr/sheets.h"
#include "ibr/warp.h"
#include "ibr/warp_scratch.h"

namespace enfilade {

/// One image on its way into a region.
struct ImageWarp {
  const Ldi& ldi;
  WarpTransform transform;
  SheetOrder order;
  std::span<ScreenBox> boxes;  ///< where each tile's samples may fall
};

/// The steps of a warp of some images into one region; what they find stands in the plan, and the
/// job's counts.  Each step needs all of the one before it to be done.
struct RegionWarp {
  const PlanarCamera& desired;
  WarpJob& job;
  const WarpOptions& options;
  WarpPlan& plan;

  /// Finds the region's pixels, and makes room for a box a tile.
  void begin() const noexcept;

  /// Sets the boxes of tiles [first, beyond), counted image after image; of columns all at once.
  void clipTiles(std::size_t first, std::size_t beyond) const noexcept;

  void countSamples() const noexcept;

  /// Cuts the region into up to `wanted` fragments; one at least.
  void cut(std::size_t wanted) const noexcept;

  /// Warps what may fall into a fragment, and hands its pixels over.  Fragments may be warped at
  /// once.
  void warpFragment(std::size_t fragment) const noexcept;

  void countPixels() const noexcept;

 private:
  template <class Visit>
  void forEachImage(Visit&& visit) const noexcept;
  void warpInto(const WarpWindow& window, const Fragment& fragment) const noexcept;
  glm::ivec4 windowOf(const Fragment& fragment) const noexcept;
};

}  // namespace enfilade
