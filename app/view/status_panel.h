#pragma once

#include <string>

#include "app/methods.h"
#include "app/view/frame_history.h"
#include "app/view/theme.h"

namespace enfilade {

/// What the panel of a method says besides its frames.
struct Status {
  Method method = Method::kLdi;
  std::string place;  ///< where one is
  std::string notes;  ///< what is unusual: flying, frozen, half resolution
  bool graph = true;
};

/// The panel of a method: what its frames cost and what went into them.  Returns the box that it
/// takes.  `corner`: its upper left corner, or its upper right one if `to_the_left`.
PixelBox drawStatus(OverlayPainter& overlay, const Theme& theme, const glm::vec2& corner,
                    bool to_the_left, const Status& status, const FrameHistory& history);

}  // namespace enfilade
