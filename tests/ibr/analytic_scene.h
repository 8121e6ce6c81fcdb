#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ibr/depth_image.h"
#include "portals/cell_graph.h"

namespace enfilade::testing {

/// A solid axis-aligned box with a colour at every point of its surface.
struct SolidBox {
  glm::dvec3 min, max;
  glm::dvec3 color{0.7, 0.7, 0.7};
  double contrast = 0.5;    ///< of the texture, 0: flat
  bool inside_out = false;  ///< a room: seen from inside
};

/// Boxes seen by rays in double precision: the tests' oracle.
struct AnalyticScene {
  std::vector<SolidBox> boxes;

  struct Hit {
    double t = 0;  ///< ray parameter; < 0: the sky
    glm::dvec3 color{0};
  };
  /// The first surface with t > least.
  Hit cast(const glm::dvec3& origin, const glm::dvec3& direction, double least = 1e-9) const;
};

/// A room of 5 × 2.8 × 4 m behind the doorway of doorway(), furnished, textured.
AnalyticScene furnishedRoom();

/// A doorway 1.0 × 2.1 m in the plane z = 0, seen from its front, z > 0.
Portal doorway();

/// What `camera` sees of what lies beyond its image plane.
DepthImage castImage(const AnalyticScene& scene, const PlanarCamera& camera);

/// What `camera` sees of what lies beyond the plane z = 0, in the pixels of `region`; δ = 0 in the
/// others.
DepthImage castThroughDoorway(const AnalyticScene& scene, const PlanarCamera& camera,
                              std::span<const glm::vec2> region);

}  // namespace enfilade::testing
