#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace enfilade {

/// A smooth curve through points (radius, height), walked at even speed from t = 0 to 1.
/// Catmull–Rom; a point given twice makes a sharp edge.
class ProfileCurve {
 public:
  explicit ProfileCurve(std::vector<glm::dvec2> points);
  glm::dvec2 at(double t) const;

 private:
  glm::dvec2 spline(std::size_t segment, double t) const;

  std::vector<glm::dvec2> points_;
  std::vector<glm::dvec2> samples_;  ///< close together along the curve
  std::vector<double> lengths_;      ///< from the start to each sample
};

}  // namespace enfilade
