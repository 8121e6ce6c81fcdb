#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include "ibr/image_parameters.h"
#include "ibr/portal_frame.h"

namespace enfilade {

/// Viewpoints along the semicircle before a portal, each for an image of its own, and which of them
/// is the nearest by angle as seen from the portal's middle, in plan.
/// Source: Rafferty et al. 1998, sec. 4.
class ViewpointFan {
 public:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  ViewpointFan() = default;
  /// `count` viewpoints, from left to right as the viewer sees it; fewer where a sloping portal has
  /// some of them not before its plane.
  ViewpointFan(const Portal& portal, bool from_front, float eye_y,
               const ImageParameters& parameters, int count);

  const std::vector<glm::dvec3>& viewpoints() const noexcept { return viewpoints_; }
  std::size_t size() const noexcept { return viewpoints_.size(); }

  /// In plan, from straight before the portal's middle: positive to the viewer's right [radians].
  double bearing(const glm::dvec3& point) const noexcept;

  /// The viewpoint nearest by angle to `eye` among those for which eligible(index) holds; of two as
  /// near the one farther left; kNone if none is eligible.
  template <class Eligible>
  std::size_t nearest(const glm::dvec3& eye, Eligible&& eligible) const {
    const double eye_bearing = bearing(eye);
    std::size_t best = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < bearings_.size(); ++i) {
      const double apart = std::abs(bearings_[i] - eye_bearing);
      if (apart < least && eligible(i)) {
        least = apart;
        best = i;
      }
    }
    return best;
  }

 private:
  PortalFrame frame_;
  std::vector<glm::dvec3> viewpoints_;
  std::vector<double> bearings_;
};

}  // namespace enfilade
