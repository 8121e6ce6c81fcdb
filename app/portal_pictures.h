#pragma once

#include <vector>

#include "app/frame_record.h"
#include "app/portal_images.h"
#include "ibr/warp.h"
#include "render/renderer.h"
#include "visibility/portal_culling.h"

namespace enfilade {

/// Where a portal's image stands: as large as the portal is taken for in culling, since the solid
/// jambs stand before what is too much.
ScreenPolygon screenPolygonOf(const Portal& portal);

/// The choice "geometry or image" for each portal, and the images' way into the frame.
/// A portal side shows its image when it has one, the eye is on that side, and farther from the
/// portal than the house's switch distance.
/// Source: Rafferty, Aliaga, Popescu & Lastra 1998, sec. 3 and 4.
class PortalPictures {
 public:
  /// Both must outlive it.
  PortalPictures(const House& house, const PortalImages& images, int width, int height);

  /// Whether the portal shows its image to `eye`.
  bool showsImage(const glm::vec3& eye, PortalId portal, bool from_front) const;

  /// Warps the image of every portal of `set` that is shown as one to `camera` and has `renderer`
  /// draw it in the portal.  Fills in the times of both and what was warped in `cost`.  The same
  /// pixels for any number of threads.
  void draw(const VisibleSet& set, const Camera& camera, Renderer& renderer, FrameCost& cost);

 private:
  /// One portal's picture of the frame: it has a buffer of its own, so that portals are warped at
  /// once, and two whose regions overlap on screen do not meet; depth decides between them.
  struct Picture {
    const VisiblePortal* portal = nullptr;
    glm::ivec4 box{0};  ///< x0, y0, x1, y1 of the pixels that may be written
    WarpCounts counts;
    WarpBuffer buffer;
  };
  void warp(const PlanarCamera& desired, Picture& picture) const;
  void addCounts(FrameCost& cost) const;

  const House& house_;
  const PortalImages& images_;
  int width_, height_;
  std::vector<Picture> pictures_;  ///< kept between frames; the first `used_` are this frame's
  std::size_t used_ = 0;
};

}  // namespace enfilade
