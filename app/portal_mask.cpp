#include "app/portal_mask.h"

#include <algorithm>

namespace enfilade {

std::vector<std::uint8_t> pixelsOf(const PortalMask& mask, std::size_t index) {
  const std::size_t value = std::min<std::size_t>(index + 1, 255);
  std::vector<std::uint8_t> pixels(mask.of_pixel.size());
  std::transform(mask.of_pixel.begin(), mask.of_pixel.end(), pixels.begin(),
                 [&](std::uint8_t pixel) { return std::uint8_t{pixel == value}; });
  return pixels;
}

std::vector<PortalSwitch> switchesBetween(const std::vector<SeenPortal>& before,
                                          const std::vector<SeenPortal>& after) {
  std::vector<PortalSwitch> switches;
  for (const SeenPortal& old : before) {
    const auto now = std::find_if(after.begin(), after.end(),
                                  [&](const SeenPortal& seen) { return seen.side == old.side; });
    if (now == after.end() || now->as_image == old.as_image) continue;
    switches.push_back({old.side, old.as_image});
  }
  return switches;
}

}  // namespace enfilade
