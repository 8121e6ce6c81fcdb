#pragma once

#include <glm/glm.hpp>

#include "ibr/planar_camera.h"

namespace enfilade {

/// Where the samples of one planar camera fall in another: a sample (u, v, δ) has the homogeneous
/// place (x·w, y·w, w) = M·(u, v, 1) + δ·e there and the disparity δ / w; w > 0 before the centre.
/// Linear in u, v and δ, so that a row is warped by increments.
/// Source: McMillan & Bishop, Plenoptic Modeling, 1995.
struct WarpTransform {
  glm::dmat3 to_from_pixel{1};  ///< M = P₂⁻¹·P₁
  glm::dvec3 per_disparity{0};  ///< e = P₂⁻¹·(c₁ − c₂)

  glm::dvec3 homogeneous(double u, double v, double disparity) const noexcept {
    return to_from_pixel * glm::dvec3(u, v, 1.0) + disparity * per_disparity;
  }
};

WarpTransform warpTransform(const PlanarCamera& from, const PlanarCamera& to);

}  // namespace enfilade
