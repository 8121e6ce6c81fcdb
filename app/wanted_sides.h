#pragma once

#include <vector>

#include "app/image_choice.h"
#include "visibility/portal_culling.h"

namespace enfilade {

/// The portal sides whose images a frame wants to have in memory, by sideIndex(), the most urgent
/// first: those in view beyond the switch distance, then those that a step, a turn or an opening
/// door may bring into view: of the cells in view and of the cells next to them.  The nearest
/// first.
struct WantedSides {
  std::vector<std::size_t> sides;
  std::size_t in_view = 0;  ///< the first so many are in view
};

/// Fills in `wanted` for an eye at `eye` that sees `set`.
void findWantedSides(const House& house, const VisibleSet& set, const glm::vec3& eye,
                     WantedSides& wanted);

}  // namespace enfilade
