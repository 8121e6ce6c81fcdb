#pragma once

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

  /// Swaps the images of `kind` with those of `other`, a side with as many viewpoints.
  void swap(ImageKind kind, SideImages& other) noexcept;
};

/// Where the images of a portal's side are read from.
struct SideFiles {
  const House& house;
  const std::string& folder;  ///< of the house
  PortalId portal = 0;
  bool from_front = true;
};

/// Reads the images of `kind` that the house lists, one for each viewpoint of `images`; leaves
/// those of other kinds.  Throws Error (kBadInput) for an image that is missing, cannot be read, or
/// is not the one that was written with the house.
void readSideImages(const SideFiles& files, ImageKind kind, SideImages& images);

/// What a house has of one kind of images of a side.
struct StoredImages {
  std::size_t count = 0;
  std::size_t bytes = 0;  ///< that they will take in memory
};

/// The same by the files' headers alone.  Throws as readSideImages() does, but for what only
/// reading all of a file can tell.
StoredImages lookAtSideImages(const SideFiles& files, ImageKind kind, const SideImages& images);

}  // namespace enfilade
