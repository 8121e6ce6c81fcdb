#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/image_choice.h"
#include "app/recency.h"
#include "ibr/portal_ldi.h"
#include "visibility/object_index.h"

namespace enfilade {

/// Makes the images that one method shows while one walks, at most one capture a frame.
///
/// Of the portal sides in view beyond the switch distance that lack an image, first those that have
/// none at all, then those that show another than they should; of these the largest on screen.
/// Textures and reference images take one capture each.  A layered depth image is shown as soon as
/// three captures are in it, and grows by one a frame until it has all of them.
///
/// What is kept is bounded: when it is more than that, the sides seen the longest ago lose theirs,
/// but none that is in view.  The same images for the same walk, run after run.
class ImageMaker {
 public:
  static constexpr std::size_t kMostBytes = std::size_t{256} << 20;

  /// All must outlive it.  `most_bytes`: how much is kept.  Throws Error (kBadInput) for parameters
  /// in the house that cannot be.
  ImageMaker(const MethodInfo& method, const House& house, const ObjectIndex& objects,
             Renderer& renderer, std::size_t most_bytes = kMostBytes);

  /// The images made so far.
  const PortalImages& images() const noexcept { return images_; }

  /// Makes what the frame of `set`, seen from `eye`, lacks the most, drawing with the renderer
  /// before the frame begins.  Returns whether there was anything to make.
  bool makeOne(const VisibleSet& set, const glm::vec3& eye);

  /// Forgets all images.
  void forget();

  std::size_t bytes() const noexcept { return kept_.bytes(); }  ///< now

 private:
  struct Side {
    std::unique_ptr<PortalLdi> making;  ///< a layered depth image that is not complete
    bool complete = false;              ///< the layered depth image was made
  };
  /// A portal side in need of an image.
  struct Need {
    const VisiblePortal* portal = nullptr;
    bool has_none = false;
    double area = 0;  ///< on screen
    bool before(const Need& other) const noexcept;
  };

  Side& sideOf(const VisiblePortal& visible);
  bool lacks(const VisiblePortal& visible, const glm::vec3& eye);
  void make(const VisiblePortal& visible, const glm::vec3& eye);
  void makeLdi(Side& side, SideImages& images, const VisiblePortal& visible,
               const CaptureFunction& capture);
  void evict();

  MethodInfo method_;
  const House& house_;
  const ObjectIndex& objects_;
  Renderer& renderer_;
  ImageParameters parameters_;
  double far_depth_;
  std::size_t most_bytes_;
  PortalImages images_;
  std::vector<Side> sides_;  ///< index 2 · portal + (from_front ? 0 : 1)
  Recency kept_;             ///< of the sides, by frames in which they were seen
};

}  // namespace enfilade
