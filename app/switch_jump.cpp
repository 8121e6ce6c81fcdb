#include "app/switch_jump.h"

#include <algorithm>

namespace enfilade {

std::optional<SwitchJump> measureJump(FramePainter& painter, Method method, const Camera& camera,
                                      const PortalSwitch& event) {
  Image with_image, with_geometry;
  PortalMask mask;
  painter.paint(method, camera);
  painter.read(with_image);
  painter.readPortalMask(mask);
  const auto side = std::find(mask.sides.begin(), mask.sides.end(), event.side);
  if (side == mask.sides.end()) return std::nullopt;
  const std::vector<std::uint8_t> pixels =
      pixelsOf(mask, static_cast<std::size_t>(side - mask.sides.begin()));
  const std::size_t count =
      pixels.size() - static_cast<std::size_t>(std::count(pixels.begin(), pixels.end(), 0));
  if (count == 0) return std::nullopt;

  painter.paint(method, camera, {event.side});
  painter.read(with_geometry);
  return SwitchJump{method,
                    0,
                    event,
                    count,
                    *meanDifference(with_image, with_geometry, pixels),
                    *psnr(with_image, with_geometry, pixels)};
}

}  // namespace enfilade
