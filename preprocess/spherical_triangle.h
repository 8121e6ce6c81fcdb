#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace enfilade {

/// The part of a convex polygon that stands above the horizon of a point: dot(p − point, normal)
/// more than 0.  Fewer than three corners: none of it.
/// Source: Sutherland & Hodgman, Reentrant Polygon Clipping, 1974.
std::vector<glm::vec3> aboveHorizon(std::span<const glm::vec3> polygon, const glm::vec3& point,
                                    const glm::vec3& unit_normal);

/// The integral of the cosine over the directions to a polygon above the horizon [sr·1], 0…π,
/// from whichever side it is seen.
/// Source: Lambert, Photometria, 1760; Schröder & Hanrahan, On the Form Factor between Two
/// Polygons, 1993.
float cosineIntegral(std::span<const glm::vec3> polygon, const glm::vec3& point,
                     const glm::vec3& unit_normal);

/// A triangle on the unit sphere about a point, whose directions can be drawn evenly.
/// Source: Arvo, Stratified Sampling of Spherical Triangles, 1995.
class SphericalTriangle {
 public:
  /// Unit directions to the corners.
  SphericalTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

  float solidAngle() const noexcept { return solid_angle_; }  ///< [sr] 0 if it has none

  /// A unit direction; even over the triangle for s and t even over 0…1.
  glm::vec3 direction(float s, float t) const noexcept;

 private:
  glm::dvec3 a_, b_, c_;
  double alpha_ = 0, cos_c_ = 1;
  float solid_angle_ = 0;
};

}  // namespace enfilade
