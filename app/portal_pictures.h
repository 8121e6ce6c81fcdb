#pragma once

#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "app/frame_record.h"
#include "app/image_choice.h"
#include "app/portal_mask.h"
#include "app/warping.h"
#include "render/renderer.h"
#include "render/thread_team.h"
#include "visibility/portal_culling.h"

namespace enfilade {

/// Where a portal's image stands: as large as the portal is taken for in culling, since the solid
/// jambs stand before what is too much.
ScreenPolygon screenPolygonOf(const Portal& portal);

/// Gives an image to warp in place of another; it must live until the next call.
using LdiStandIn = std::function<const Ldi*(const Ldi& image)>;

/// The way of the portals' images into the frame: warped, or mapped on the portal.
/// Source: Rafferty, Aliaga, Popescu & Lastra 1998, sec. 3 and 4.
class PortalPictures {
 public:
  /// `house` must outlive it.  `threads`: that warp, 0: as many as the machine has.
  PortalPictures(const House& house, int width, int height, int threads);

  /// Frames are of this size from now on.
  void resize(int width, int height);

  /// See FramePainter::setStandIn.
  void setStandIn(LdiStandIn stand_in) { stand_in_ = std::move(stand_in); }

  /// How images are warped from now on.
  void setWarping(const Warping& warping);

  /// Warps what `method` shows of `images` to an eye at `chosen_for` in every portal of `set` that
  /// is shown as an image to `camera`, and has `renderer` draw it in the portal.  Fills in the
  /// times of both and what was warped in `cost`.  The same pixels for any number of threads.
  void draw(const MethodInfo& method, const PortalImages& images, const VisibleSet& set,
            const glm::vec3& chosen_for, const Camera& camera, Renderer& renderer, FrameCost& cost);

  /// How many pixels of `mask`, that of the frame drawn last, no sample fell into.
  std::size_t uncoveredPixels(const PortalMask& mask) const noexcept;

  /// The same pixel by pixel: 1 where none fell.
  void markUncovered(const PortalMask& mask, std::vector<std::uint8_t>& out) const;

 private:
  /// One portal's picture of the frame: it has a buffer of its own, so that portals are warped at
  /// once, and two whose regions overlap on screen do not meet; depth decides between them.
  struct Picture {
    explicit Picture(const std::shared_ptr<WarpScratch>& scratch) : buffer(scratch) {}

    const VisiblePortal* portal = nullptr;
    ChosenImages chosen;
    glm::ivec4 box{0};  ///< x0, y0, x1, y1 of the pixels that may be written
    std::vector<std::vector<glm::vec2>> regions;  ///< [pixels]
    WarpBuffer buffer;
  };
  void choose(const MethodInfo& method, const PortalImages& images, const VisibleSet& set,
              const glm::vec3& eye);
  bool isUncovered(const PortalMask& mask, std::size_t pixel) const noexcept;
  void begin(Picture& picture) const;
  WarpCounts warpRound(const PlanarCamera& desired, std::size_t round);
  void fillHoles(Method method);
  void warpAll(Method method, const Camera& camera, FrameCost& cost);
  void drawWarped(const Picture& picture, const Camera& camera, Renderer& renderer) const;
  void drawTexture(const Picture& picture, const Camera& camera, Renderer& renderer) const;

  const House& house_;
  float texture_margin_;  ///< [m] beyond the portals' rectangles
  int width_, height_;
  ThreadTeam team_;
  Warping warping_;
  LdiStandIn stand_in_;
  HoleFiller filler_;
  std::map<Method, Image> before_;  ///< the warped images of its frame before, if holes persist
  Image now_;                       ///< those of the frame at hand
  std::vector<glm::ivec2> spans_;
  std::vector<WarpJob> jobs_;
  std::shared_ptr<WarpScratch> scratch_;
  std::deque<Picture> pictures_;  ///< kept between frames; the first `used_` are this frame's
  std::size_t used_ = 0;
};

}  // namespace enfilade
