#pragma once

#include <array>

#include "app/methods.h"
#include "app/portal_images.h"

namespace enfilade {

/// Whether the switch rule gives a portal side an image: the eye is on that side, and farther from
/// the portal than the house's switch distance.
/// Source: Rafferty, Aliaga, Popescu & Lastra 1998, sec. 4.
bool isBeyondSwitch(const House& house, const glm::vec3& eye, PortalId portal, bool from_front);

/// The images that a portal side shows to an eye.
struct ChosenImages {
  const Image* texture = nullptr;      ///< mapped on the portal; null: images are warped
  std::size_t texture_index = 0;       ///< its viewpoint
  std::array<const Ldi*, 2> warped{};  ///< the farther first
  std::size_t warped_count = 0;
};

/// What `method` shows of the images that a side has: of textures and reference images the nearest
/// by angle that are there.
ChosenImages chooseImages(const MethodInfo& method, const SideImages& images,
                          const glm::dvec3& eye);

/// The viewpoint of the texture or reference image that `method` should show to `eye` and the side
/// does not have yet, the nearest by angle first; ViewpointFan::kNone if nothing is missing.
std::size_t missingViewpoint(const MethodInfo& method, const SideImages& images,
                             const glm::dvec3& eye);

}  // namespace enfilade
