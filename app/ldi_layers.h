#pragma once

#include <string>
#include <vector>

#include "ibr/ldi.h"
#include "portals/house.h"
#include "scene/image.h"

namespace enfilade {

/// The samples of one portal side's layered depth image, by layer.
struct SideLayers {
  PortalId portal = 0;
  bool from_front = true;
  std::vector<std::size_t> samples;  ///< in layer one, two …

  std::size_t total() const;
};

/// What stands under `folder` of every portal side that has an image.  Throws Error (kBadInput) for
/// an image that cannot be read.
std::vector<SideLayers> countLayers(const House& house, const std::string& folder);

/// The sum over all sides.
std::vector<std::size_t> samplesInAll(const std::vector<SideLayers>& sides);

/// The side with the most samples of those of portal `portal` (or of any, if < 0) on side `side`
/// ("front", "back", or "" for either).  Throws Error (kUsage) if there is none.
const SideLayers& chooseSide(const std::vector<SideLayers>& sides, int portal,
                             const std::string& side);

/// Layer `layer` (1 is the nearest) as a picture: transparent where it has no sample, cropped to
/// the pixels where some layer has one, so that the pictures of all layers lie on each other.
/// Throws Error (kBadInput) that names `subject` if that would be more than 2²⁶ pixels.
/// Source: Rafferty et al. 1998, colour figure F.
Image layerPicture(const Ldi& ldi, std::size_t layer, const std::string& subject);

/// Writes FOLDER/layer-1.png … of one side's image; returns how many.
std::size_t writeLayerPictures(const House& house, const std::string& house_folder,
                               const SideLayers& side, const std::string& folder);

/// A table of the samples in layers 1, 2, 3 and 4 and more, in numbers and percent (Rafferty et al.
/// 1998, Figure 5), a side a line and all of them last.
std::string layersText(const std::vector<SideLayers>& sides);

}  // namespace enfilade
