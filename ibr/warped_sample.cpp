// McMillan & Bishop, Plenoptic Modeling, 1995, sec. 3.
#include "ibr/warped_sample.h"

namespace enfilade {

WarpedSample warpSample(const WarpTransform& warp, const CaptureSample& s) noexcept {
  const auto disparity = static_cast<double>(s.disparity);
  const glm::dvec3 h =
      warp.homogeneous(static_cast<double>(s.u), static_cast<double>(s.v), disparity);
  const glm::dvec2 at = glm::dvec2(h) / h.z;

  // Along the surface the disparity changes with u and v.
  const glm::dvec3 per_u =
      warp.to_from_pixel[0] + static_cast<double>(s.slope_u) * warp.per_disparity;
  const glm::dvec3 per_v =
      warp.to_from_pixel[1] + static_cast<double>(s.slope_v) * warp.per_disparity;
  const glm::dvec2 side_u = (glm::dvec2(per_u) - at * per_u.z) / h.z;
  const glm::dvec2 side_v = (glm::dvec2(per_v) - at * per_v.z) / h.z;
  const glm::dvec2 size = static_cast<double>(s.width) * glm::abs(side_u) +
                          static_cast<double>(s.height) * glm::abs(side_v);
  return {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(disparity / h.z),
          static_cast<float>(size.x), static_cast<float>(size.y)};
}

}  // namespace enfilade
