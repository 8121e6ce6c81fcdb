#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/side_images.h"
#include "portals/house.h"

namespace enfilade {

/// The images of a house in memory, two sides a portal.
class PortalImages {
 public:
  PortalImages() = default;
  /// The viewpoints of every side that gets images, and no image yet.  Throws Error (kBadInput) for
  /// parameters in the house that cannot be.
  explicit PortalImages(const House& house);
  /// Reads the images of `kinds` that the house in `folder` lists.  Throws Error (kBadInput) for
  /// one that is missing, damaged or another's, and (kMachine) for more than the machine's memory.
  PortalImages(const House& house, const std::string& folder, const ImageKinds& kinds = {});

  /// Reads those of `kinds` too.  Throws as the constructor does.
  void read(const House& house, const std::string& folder, const ImageKinds& kinds);

  /// Throws Error (kMachine) if those of `kinds` would take more than `machine` bytes of memory.
  void requireMemory(const House& house, const std::string& folder, const ImageKinds& kinds,
                     std::uint64_t machine) const;

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
