#pragma once

#include "app/frame_painter.h"

namespace enfilade {

/// Paints over the pixels of the painter's last frame: those of a portal's image in a colour of the
/// portal's own, if `tint`; those that no sample fell into in magenta, if `uncovered`.  `out`: the
/// frame's size, transparent elsewhere.  The painter's depth is lost.
void markPixels(FramePainter& painter, bool tint, bool uncovered, Image& out);

}  // namespace enfilade
