#pragma once

#include <cstdint>
#include <vector>

#include "portals/cell_graph.h"

namespace enfilade {

/// A portal side that a frame sees, and what the frame shows there.
struct SeenPortal {
  PortalSide side;
  bool as_image = false;  ///< else the geometry behind it
};

/// Which pixels of a frame have their colour from a portal's image.  What stands before the portal
/// does not count; what the image left uncovered does, whatever shows through there.
struct PortalMask {
  std::vector<PortalSide> sides;  ///< those that show images
  /// One a pixel, row 0 on top: 0 none, else 1 + the index in `sides`, 255 for all from the 255th
  /// on.  Empty: the frame shows no images.
  std::vector<std::uint8_t> of_pixel;
};

/// The pixels of sides[index] alone, as a mask.
std::vector<std::uint8_t> pixelsOf(const PortalMask& mask, std::size_t index);

/// A portal side that shows its image in one of two successive frames and geometry in the other.
struct PortalSwitch {
  PortalSide side;
  bool to_geometry = false;  ///< the first of the two shows the image

  bool operator==(const PortalSwitch& other) const = default;
};

/// The switches between a frame and the one after it: of the portals that both of them see.
std::vector<PortalSwitch> switchesBetween(const std::vector<SeenPortal>& before,
                                          const std::vector<SeenPortal>& after);

}  // namespace enfilade
