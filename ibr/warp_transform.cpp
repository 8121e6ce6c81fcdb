// McMillan & Bishop, Plenoptic Modeling, 1995, sec. 3.
#include "ibr/warp_transform.h"

namespace enfilade {

WarpTransform warpTransform(const PlanarCamera& from, const PlanarCamera& to) {
  const glm::dmat3 to_from_world = glm::inverse(to.world_from_pixel);
  return {to_from_world * from.world_from_pixel, to_from_world * (from.center - to.center)};
}

}  // namespace enfilade
