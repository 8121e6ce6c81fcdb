#pragma once

#include <optional>

#include "app/frame_painter.h"

namespace enfilade {

/// How far the picture jumps when a portal changes between its image and geometry: both at one
/// pose, that of the frame nearest to the change that shows the image, in the portal's pixels.
struct SwitchJump {
  Method method = Method::kGeometry;
  std::size_t frame = 0;  ///< that shows the image
  PortalSwitch event;
  std::size_t pixels = 0;  ///< of the portal's image in that frame
  double levels = 0;       ///< mean absolute difference [8-bit levels] over red, green and blue
  double psnr_db = 0;      ///< at most kIdenticalPsnr
};

/// Paints the frame that `camera` sees by `method` twice, with the image of `event.side` and with
/// geometry in its place (whose own portals show images in turn), and compares.  Empty if nothing
/// of the image is in sight.  `frame` of the result is 0.
std::optional<SwitchJump> measureJump(FramePainter& painter, Method method, const Camera& camera,
                                      const PortalSwitch& event);

}  // namespace enfilade
