#pragma once

#include <string>

#include "scene/camera_path.h"

namespace enfilade {

/// `path` as a film shows it: a pose every 1/`frames_per_second` seconds from the first pose's time
/// to the last's, interpolated between the path's own; doors move at their times.  A path whose
/// poses all have one time stays as it is: a pose a frame.  Throws Error (kBadInput) that names
/// `file` if the film would have more than a million frames.
CameraPath filmPath(const CameraPath& path, int frames_per_second, const std::string& file);

}  // namespace enfilade
