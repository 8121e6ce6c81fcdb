#pragma once

#include <string>
#include <vector>

#include "portals/house.h"
#include "scene/camera_path.h"

namespace enfilade {

struct TourParameters {
  int frames = 520;           ///< [2…1 000 000]
  float body_radius = 0.2f;   ///< [m] [> 0] free room kept around the walker
  float step_height = 0.35f;  ///< [m] [> 0] the highest step that a walker climbs
  float head_room = 1.8f;     ///< [m] [> 0]
};

struct Tour {
  CameraPath path;
  std::vector<CellId> visited;     ///< cells that the path enters, increasing
  std::vector<std::string> notes;  ///< cells that cannot be reached on foot, and why, a line each
};

/// A walk at eye height through every cell that a person can reach on foot, doors open, that never
/// passes through a wall. The same path run after run.  Throws Error (kBadInput) if there is
/// nowhere to stand.
Tour makeTour(const House& house, const TourParameters& parameters);

}  // namespace enfilade
