#pragma once

#include <array>
#include <string>
#include <vector>

#include "ibr/image_kinds.h"
#include "ibr/ldi.h"
#include "ibr/viewpoint_fan.h"
#include "portals/house.h"
#include "scene/image.h"

namespace enfilade {

/// The images of one side of a portal: what a viewer on that side sees through it.
struct SideImages {
  ViewpointFan texture_fan;     ///< where the textures are taken from
  ViewpointFan reference_fan;   ///< where the reference images are taken from
  std::vector<Image> textures;  ///< one for each viewpoint; empty where there is none
  std::vector<Ldi> references;  ///< likewise
  Ldi ldi;                      ///< empty if there is none

  bool hasTexture(std::size_t i) const noexcept { return !textures[i].rgba.empty(); }
  bool hasReference(std::size_t i) const noexcept { return !references[i].samples.empty(); }
  bool has(ImageKind kind) const noexcept;  ///< any image of the kind
  std::size_t count(ImageKind kind) const noexcept;
  std::size_t bytes() const noexcept;  ///< that the images take in memory
};

/// The images of a house in memory, two sides a portal.
class PortalImages {
 public:
  PortalImages() = default;
  /// The viewpoints of every side that gets images, and no image yet.  Throws Error (kBadInput) for
  /// parameters in the house that cannot be.
  explicit PortalImages(const House& house);
  /// Reads the images of `kinds` that the house in `folder` lists.  Throws Error (kBadInput) for
  /// one that is missing, damaged or another's.
  PortalImages(const House& house, const std::string& folder, const ImageKinds& kinds = {});

  /// Reads those of `kinds` too.  Throws as the constructor does.
  void read(const House& house, const std::string& folder, const ImageKinds& kinds);

  /// A side without images if there is none such.
  const SideImages& side(PortalId portal, bool from_front) const noexcept;
  /// The portal must be one of the house's.
  SideImages& side(PortalId portal, bool from_front) noexcept;

  std::size_t count(ImageKind kind) const noexcept;  ///< images of the kind
  std::size_t count() const noexcept;                ///< all images

 private:
  std::vector<SideImages> sides_;  ///< index 2 · portal + (from_front ? 0 : 1)
};

/// How many images of each kind a house lists.
struct ImageCounts {
  std::size_t sides = 0;  ///< portal sides with any
  std::size_t textures = 0, references = 0, ldis = 0;
};
ImageCounts countImages(const House& house);

}  // namespace enfilade
