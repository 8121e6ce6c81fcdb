#pragma once

#include <string>
#include <vector>

#include "scene/camera.h"

namespace enfilade {

struct TimedPose {
  double time = 0;  ///< [s], not decreasing along a path
  Pose pose;
};

/// A scripted walk: one pose a frame.
struct CameraPath {
  std::string name;
  float vertical_fov = 1.047f;  ///< [rad]
  std::vector<TimedPose> poses;
};

/// Reads a path.  By content, whatever the extension: our JSON ({"enfilade": "tour", "version": 1,
/// …}), TUM
/// (`timestamp tx ty tz qx qy qz qw` lines, `#` comments), or a glTF/GLB whose camera node is
/// animated (sampled `frames_per_second` times a second).  Throws Error (kBadInput) that says what
/// the file seems to be.
CameraPath readCameraPath(const std::string& file, double frames_per_second = 30.0);

/// Writes our JSON, by way of a temporary name.  Throws Error (kMachine).
void writeCameraPath(const std::string& file, const CameraPath& path);

/// Writes TUM lines, by way of a temporary name.  Throws Error (kMachine).
void writeTumPath(const std::string& file, const CameraPath& path);

}  // namespace enfilade
