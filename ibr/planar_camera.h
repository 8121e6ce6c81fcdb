#pragma once

#include <glm/glm.hpp>

#include "scene/camera.h"

namespace enfilade {

/// A centre of projection and an image plane: the ray of pixel (u, v) goes from `center` through
/// center + P·(u, v, 1), where P = `world_from_pixel` has the columns a (one pixel to the right), b
/// (one pixel down) and c (to the image's top left corner).  Pixel centres are at half integers.
/// World, right-handed, metres. A point seen at pixel (u, v) with disparity δ is X = center + P·(u,
/// v, 1) / δ; δ = 1 on the image plane. Source: McMillan & Bishop, Plenoptic Modeling, 1995.
struct PlanarCamera {
  glm::dvec3 center{0};
  glm::dmat3 world_from_pixel{1};
  int width = 0;
  int height = 0;
};

/// The planar camera whose image plane is the near plane of `camera`.
PlanarCamera planarCamera(const Camera& camera, int width, int height);

/// The OpenGL view of a planar camera: near plane at the image plane, far plane at `far_depth` [m]
/// from the centre, which must lie beyond the image plane.
View viewOf(const PlanarCamera& camera, double far_depth);

/// Distance from the centre to the image plane [m].
double imagePlaneDistance(const PlanarCamera& camera);

/// The disparity of an OpenGL depth 0…1 in a view made by viewOf(camera, far_depth), where `near`
/// is imagePlaneDistance(camera): δ = 1 − z·(f − n)/f.  Exact to half a step of a float near 1
/// (6e-8), so the relative error grows as 6e-8 / δ. Source: Rafferty et al. 1998, sec. 3.1.
float disparityFromDepth(float depth, double near, double far_depth) noexcept;

/// Pixel coordinates (u, v) and disparity δ of a world point, in double precision; δ ≤ 0 behind the
/// centre.
glm::dvec3 projectPoint(const PlanarCamera& camera, const glm::dvec3& world);

/// The world point seen at pixel (u, v) with disparity δ > 0.
glm::dvec3 unprojectPoint(const PlanarCamera& camera, const glm::dvec3& pixel_and_disparity);

/// The same rays through another window of the image plane: pixel (x, y) of `camera` becomes pixel
/// (0, 0).
PlanarCamera withWindow(const PlanarCamera& camera, int x, int y, int width, int height);

/// The same window with `factor` × `factor` pixels in the place of one.
PlanarCamera refined(const PlanarCamera& camera, int factor);

}  // namespace enfilade
