#pragma once

#include <vector>

#include "app/frame_record.h"
#include "app/portal_images.h"
#include "ibr/warp.h"
#include "render/renderer.h"
#include "visibility/portal_culling.h"

namespace enfilade {

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
  /// draw it in the portal.  Adds the times of both and what was warped to `cost`.
  void draw(const VisibleSet& set, const Camera& camera, Renderer& renderer, FrameCost& cost);

 private:
  const House& house_;
  const PortalImages& images_;
  WarpBuffer buffer_;
};

}  // namespace enfilade
