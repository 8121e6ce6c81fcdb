#pragma once

#include "ibr/portal_capture.h"
#include "tests/ibr/analytic_scene.h"
#include "tests/ibr/random_cameras.h"

namespace enfilade::bench {

/// The layered depth image of a furnished room's doorway, with captures of `rows` rows by exact
/// rays; some 170,000 samples for 192 rows, growing with their square.
inline Ldi roomLdi(int rows) {
  const testing::AnalyticScene room = testing::furnishedRoom();
  ImageParameters parameters;
  parameters.image_size = rows;
  return buildLdi(testing::doorway(), true, 1.6f, parameters,
                  [&](const PlanarCamera& camera) { return testing::castImage(room, camera); });
}

/// A view of the doorway from 2.2 m, 640 × 512, that the doorway nearly fills from top to bottom.
inline PlanarCamera viewOfDoorway() {
  return testing::desiredCamera({0.7, 1.6, 2.0}, {0, 1.1, 0}, 640, 512);
}

}  // namespace enfilade::bench
