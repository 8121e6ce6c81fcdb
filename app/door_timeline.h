#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "portals/house.h"
#include "scene/camera_path.h"
#include "scene/error.h"

namespace enfilade {

/// Shuts or opens the portals that `names` means (see portalsNamed()) where they can be.  Throws
/// Error (`kind`) that names `source` if there are none, or none of them has a door's leaf.
void moveDoors(const std::string& names, bool open, const std::vector<std::uint8_t>& closable,
               ErrorKind kind, const std::string& source, CellGraph& graph);

/// One flag a portal: whether it is open (Portal::active).
std::vector<std::uint8_t> doorsOf(const CellGraph& graph);

/// How a house's doors stand along a path.
class DoorTimeline {
 public:
  /// Doors that the path does not move.
  DoorTimeline() = default;
  /// At first as they are in `house`.  Throws Error (kBadInput) that names `file` for doors that
  /// are not there.
  DoorTimeline(const CameraPath& path, const House& house, const std::string& file);

  /// One flag a portal, or null where nothing ever moves.  `time` is the path's own [s].
  const std::vector<std::uint8_t>* at(double time) const noexcept;

 private:
  struct Doors {
    double time;                     // from then on
    std::vector<std::uint8_t> open;  // one a portal
  };
  std::vector<Doors> doors_;  // by time, the first since ever
};

}  // namespace enfilade
