#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/frame_painter.h"
#include "scene/camera_path.h"
#include "scene/error.h"

namespace enfilade {

/// Shuts or opens the portals that `names` means (see portalsNamed()) where they can be.  Throws
/// Error (`kind`) that names `source` if there are none, or none of them has a door's leaf.
void moveDoors(const std::string& names, bool open, const std::vector<std::uint8_t>& closable,
               ErrorKind kind, const std::string& source, CellGraph& graph);

/// A scripted walk through a house: where one stands and how the doors stand, frame by frame.
class Walk {
 public:
  /// The doors as they are.  `camera` gives all but the pose; `path` must outlive the walk.
  Walk(const CameraPath& path, const Camera& camera) : path_(path), camera_(camera) {}
  /// The doors as they are in `house` at first, and moved as the path says.  Throws Error
  /// (kBadInput) that names `file` for doors that are not there.
  Walk(const CameraPath& path, const Camera& camera, const House& house, const std::string& file);

  std::size_t frames() const noexcept { return path_.poses.size(); }

  /// Moves the painter's doors to where they are in a frame, and returns what the camera sees.
  Camera stepTo(std::size_t frame, FramePainter& painter) const;

 private:
  struct Doors {
    std::size_t frame;               ///< from this one on
    std::vector<std::uint8_t> open;  ///< one a portal
  };
  const CameraPath& path_;
  Camera camera_;
  std::vector<Doors> doors_;  ///< by frame, the first from 0 on; empty: as they are
};

}  // namespace enfilade
