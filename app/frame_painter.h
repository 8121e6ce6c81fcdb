#pragma once

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "app/frame_record.h"
#include "app/image_maker.h"
#include "app/limited_images.h"
#include "app/portal_mask.h"
#include "app/portal_pictures.h"
#include "app/warping.h"
#include "render/ray_caster.h"
#include "visibility/object_index.h"

namespace enfilade {

/// Where the portals' images come from.
enum class ImageSource : std::uint8_t { kBaked, kOnDemand };

/// "baked" or "on-demand".  Throws Error (kUsage) that names --images.
ImageSource parseImageSource(const std::string& name);

/// How a frame is made otherwise than its method would make it, to compare or to look into it.
struct PaintOptions {
  std::optional<PortalSide> as_geometry = {};  ///< shows no image, however far it is
  /// What is drawn, and as what, is chosen as for this camera; it is drawn as the frame's camera
  /// sees it.  No matter to rays.
  std::optional<Camera> chosen_for = {};
  bool wireframe = false;  ///< of geometry the edges alone
};

/// Makes a frame of a walk by any method and tells what it cost.  The same pixels for the same
/// pose, run after run; on demand, for the same walk since prepare().
class FramePainter {
 public:
  /// `threads`: of the ray caster and the warp, 0: as many as the machine has.  `images`: the baked
  /// ones, not used on demand.  All must outlive the painter, which changes nothing of the house
  /// but which portals are active.  Throws Error (kMachine).
  FramePainter(GlContext& context, House& house, const PortalImages& images, int width, int height,
               int threads, ImageSource source = ImageSource::kBaked);

  /// Which of the baked images are there is up to `limited` from now on, whose images they are.
  void setLimited(LimitedImages* limited) noexcept { limited_ = limited; }

  /// Frames are of this size from now on.
  void resize(int width, int height);

  /// How images are warped from now on.
  void setWarping(const Warping& warping) { pictures_.setWarping(warping); }

  /// Opens and shuts doors, `open` one flag a portal: a shut one's leaf is drawn, nothing is seen
  /// through it and it shows no image.  Forgets what was made on demand if that changes anything;
  /// baked images of other portals show the door as it stood.
  void setDoors(std::span<const std::uint8_t> open);

  /// Begins a walk by `method`: builds what it needs beforehand, so that its first frame does not
  /// pay for it, and forgets the images that it made on demand, or asked for under a limit.
  void prepare(Method method);

  /// Which frame of the walk is painted from now on, see repeatFrames().
  void setFrame(std::size_t frame) noexcept { frame_ = frame; }

  /// From now on until prepare(), frames have the images that they had when the walk was painted
  /// first, whatever order they are painted in.  No matter without a limit.
  void repeatFrames() noexcept {
    if (limited_ != nullptr) limited_->repeatFrames();
  }

  /// What is warped in place of a layered depth image or reference image from now on: what
  /// `stand_in` returns for it; nothing: itself.
  void setStandIn(LdiStandIn stand_in) { pictures_.setStandIn(std::move(stand_in)); }

  /// Paints the frame that `camera` sees and waits until it is done.
  FrameCost paint(Method method, const Camera& camera, const PaintOptions& options = {});

  /// The frame painted last.
  void read(Image& out);

  /// Copies the frame painted last to a window, see Renderer::show().  Not of a frame by rays.
  void show(const glm::ivec2& window, float left, float right) {
    renderer_.show(window.x, window.y, left, right);
  }

  /// Its OpenGL depth, row 0 on top.  Of a frame by rays: that of the frame before it.
  void readDepth(std::vector<float>& out) { renderer_.readDepth(out); }

  /// The portal sides that it sees; none where the method does not look for portals.
  const std::vector<SeenPortal>& seenPortals() const noexcept { return seen_; }

  /// What the frame painted last sees; its regions are of the camera that it was chosen for.
  /// Without a cell where the method does not look for them.
  const VisibleSet& visibleSet() const noexcept { return set_; }

  /// Which of its pixels are of portals' images.  The last to read of a frame: depth is lost.
  void readPortalMask(PortalMask& out);

  /// The share of the last frame's pixels [percent] that are of a portal's image and that no sample
  /// fell into, before any filling.  `mask`: that of the frame.
  double uncoveredPercent(const PortalMask& mask) const {
    return 100.0 * static_cast<double>(pictures_.uncoveredPixels(mask)) /
           (static_cast<double>(width_) * height_);
  }

  /// Of each of its pixels whether it counts as uncovered; `mask`: that of the frame.
  void readUncovered(const PortalMask& mask, std::vector<std::uint8_t>& out) const {
    pictures_.markUncovered(mask, out);
  }

  int width() const noexcept { return width_; }
  int height() const noexcept { return height_; }

 private:
  void paintView(const Camera& camera, const PaintOptions& options, FrameCost& cost);
  void paintRays(const Camera& camera, FrameCost& cost);
  void paintCells(const Camera& camera, const MethodInfo& method, const PaintOptions& options,
                  FrameCost& cost);
  VisibleSet cull(const View& view, const MethodInfo& method,
                  const std::optional<PortalSide>& as_geometry) const;
  VisibleSet cullAndMake(const View& view, const MethodInfo& method,
                         const std::optional<PortalSide>& as_geometry, FrameCost& cost);
  bool isThere(const MethodInfo& method, PortalId portal, bool from_front) const;
  bool isLimited(const MethodInfo& method) const noexcept {
    return limited_ != nullptr && method.portal_images && source_ == ImageSource::kBaked;
  }
  void buildRays();
  const PortalImages& imagesOf(const MethodInfo& method) const;

  House& house_;
  ObjectIndex objects_;
  ObjectList in_view_;  // of the last frame
  Renderer renderer_;
  const PortalImages& baked_;
  LimitedImages* limited_ = nullptr;  ///< null: all baked images are there
  std::size_t frame_ = 0;
  std::map<Method, ImageMaker> makers_;  ///< on demand, one for each method that shows images
  ImageSource source_;
  PortalPictures pictures_;
  std::unique_ptr<RayCaster> rays_;
  Image ray_picture_;
  VisibleSet set_;  ///< of the last frame
  std::vector<SeenPortal> seen_;
  glm::mat4 clip_from_world_{1};  ///< of the frame painted last
  int width_, height_, threads_;
  bool last_by_rays_ = false;
};

/// A camera for walking through `house`: everything in it lies before the far plane.
Camera walkingCamera(const House& house, float vertical_fov, int width, int height);

}  // namespace enfilade
