#pragma once

#include <string>

#include "app/door_timeline.h"
#include "app/frame_painter.h"
#include "scene/camera_path.h"

namespace enfilade {

/// A scripted walk through a house: where one stands and how the doors stand, frame by frame.
class Walk {
 public:
  /// The doors as they are.  `camera` gives all but the pose; `path` must outlive the walk.
  Walk(const CameraPath& path, const Camera& camera) : path_(path), camera_(camera) {}
  /// The doors as they are in `house` at first, and moved as the path says.  Throws Error
  /// (kBadInput) that names `file` for doors that are not there.
  Walk(const CameraPath& path, const Camera& camera, const House& house, const std::string& file)
      : path_(path), camera_(camera), doors_(path, house, file) {}

  std::size_t frames() const noexcept { return path_.poses.size(); }

  /// Tells the painter which frame it is, moves its doors to where they are in that frame, and
  /// returns what the camera sees.
  Camera stepTo(std::size_t frame, FramePainter& painter) const;

 private:
  const CameraPath& path_;
  Camera camera_;
  DoorTimeline doors_;
};

}  // namespace enfilade
