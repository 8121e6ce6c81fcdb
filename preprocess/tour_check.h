#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "portals/house.h"
#include "preprocess/obstacle_bins.h"
#include "scene/camera_path.h"

namespace enfilade {

/// What a walker could not have done.
struct TourViolation {
  std::size_t pose = 0;  ///< the first pose of the segment, or the pose itself
  std::string what;      ///< a line
};

/// Checks a path against the building's triangles, doors open: no segment between consecutive poses
/// crosses one, no eye is within `least_distance` [m] of one, and cells follow each other through
/// open portals only (looked up every 5 cm). Empty if nothing is wrong.
std::vector<TourViolation> checkTour(const House& house, const CameraPath& path,
                                     float least_distance = 0.15f);

/// The same with bins that are already there.
std::vector<TourViolation> checkTour(const House& house, const ObstacleBins& obstacles,
                                     const CameraPath& path, float least_distance);

/// The cells whose free space the path enters, looked up every 5 cm; increasing.
std::vector<CellId> cellsAlong(const House& house, const CameraPath& path);

}  // namespace enfilade
