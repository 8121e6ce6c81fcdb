#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ibr/ldi.h"
#include "ibr/planar_camera.h"
#include "scene/image.h"

namespace enfilade {

/// The frame-sized picture that all of a frame's images are warped into.  Alpha 0: no sample fell
/// there.
struct WarpBuffer {
  Image color;
  std::vector<std::uint32_t>
      scratch;  ///< working memory of the reconstruction, kept between frames

  void resize(int width, int height);
};

struct WarpCounts {
  std::size_t samples = 0;           ///< warped
  std::size_t samples_clipped = 0;   ///< left out because they cannot fall into the region
  std::size_t pixels = 0;            ///< in the region
  std::size_t pixels_uncovered = 0;  ///< of them, without a sample
};

/// Warps every sample of `ldi` that falls into `region` (a convex polygon in the target's pixels,
/// row 0 on top) into `target`, whose pixels there are first cleared.  Occlusion-compatible order,
/// in 4, 2 or 1 sheets. `desired` has the target's size.  The same pixels for any number of
/// threads.  Never allocates once `target` has its size. Source: McMillan & Bishop, Plenoptic
/// Modeling, 1995; sheets as in Rafferty et al. 1998, sec. 3.1.
WarpCounts warpLdi(const Ldi& ldi, const PlanarCamera& desired, std::span<const glm::vec2> region,
                   WarpBuffer& target) noexcept;

}  // namespace enfilade
