#pragma once

#include <string>

#include "ibr/portal_capture.h"

namespace enfilade {

/// Bakes a portal side's images that are each of one viewpoint, portal textures and reference
/// images, those of the kinds in `parameters.bake`, into `folder`, which must be there.  The same
/// bytes run after run.  Throws Error (kMachine).
void bakeViews(const Portal& portal, bool from_front, float eye_y,
               const ImageParameters& parameters, const CaptureFunction& capture,
               const std::string& folder);

}  // namespace enfilade
