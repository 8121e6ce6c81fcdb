#include "ibr/viewpoint_fan.h"

#include "ibr/portal_capture.h"

namespace enfilade {

ViewpointFan::ViewpointFan(const Portal& portal, bool from_front, float eye_y,
                           const ImageParameters& parameters, int count)
    : frame_(portalFrame(portal, from_front)) {
  CaptureRing fan = parameters.rings.front();
  fan.captures = count;
  for (const glm::dvec3& at : semicircleViewpoints(portal, from_front, eye_y, parameters, fan)) {
    if (!standsBefore(frame_, at)) continue;
    viewpoints_.push_back(at);
    bearings_.push_back(bearing(at));
  }
}

double ViewpointFan::bearing(const glm::dvec3& point) const noexcept {
  const glm::dvec3 to_point = point - frame_.center;
  return std::atan2(glm::dot(to_point, frame_.right), glm::dot(to_point, levelAhead(frame_)));
}

}  // namespace enfilade
