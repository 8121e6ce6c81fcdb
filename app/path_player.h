#pragma once

#include <string>

#include "app/door_timeline.h"
#include "scene/camera_path.h"

namespace enfilade {

/// A scripted walk by the clock: where one stands and how the doors stand at any time.
class PathPlayer {
 public:
  /// The doors as they are in `house` at first, and moved as the path says.  `path` has poses.
  /// Throws Error (kBadInput) that names `file` for doors that are not there.
  PathPlayer(CameraPath path, const House& house, const std::string& file);

  const CameraPath& path() const noexcept { return path_; }
  double duration() const noexcept;  ///< [s] from the first pose to the last

  /// The pose at a time since the first pose [s]; before it the first, behind the last the last.
  Pose poseAt(double time) const;

  /// One flag a portal, see FramePainter::setDoors; null where the path moves none.
  const std::vector<std::uint8_t>* doorsAt(double time) const;

 private:
  CameraPath path_;
  DoorTimeline doors_;
};

/// The pose of a path with poses at its own `time` [s]: position linear, rotation slerp.
Pose poseAt(const CameraPath& path, double time);

}  // namespace enfilade
