#pragma once

#include <vector>

#include "preprocess/obstacle_bins.h"
#include "preprocess/walk_path.h"
#include "scene/camera_path.h"

namespace enfilade {

/// A moment of a tour, before frames are chosen: evenly spaced along the way.
struct TourSample {
  glm::vec3 eye{0};       ///< [m]
  float yaw = 0;          ///< [rad] not wrapped: differences are turns
  float pitch = 0;        ///< [rad]
  CellId cell = kNoCell;  ///< where the walker's head is
  bool visit = false;
  double effort = 0;  ///< [m] from the start: way walked, and turns as way (kMetresPerTurn)
};

/// A turn by a radian takes as long as walking this far [m].
inline constexpr float kMetresPerTurn = 0.9f;

/// The moments of a walk along `path`: eye height over the smoothed floor, the view ahead along the
/// way, looking around in rooms that are walked through, a little up or down on stairs.
/// `frames` tells how hurried the walk is: a hurried walker looks around less.
std::vector<TourSample> filmWalk(const WalkGrid& grid, const ObstacleBins& obstacles,
                                 const WalkPath& path, int frames);

/// Exactly `frames` poses, 1/30 s apart, evenly by effort as near as can be: each visit is a pose,
/// and where the straight line between two poses would cross something solid, poses are closer.
/// A pose turns by no more than about (whole effort / frames) / kMetresPerTurn.
std::vector<TimedPose> chooseFrames(const std::vector<TourSample>& samples,
                                    const ObstacleBins& obstacles, int frames);

}  // namespace enfilade
