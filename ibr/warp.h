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

  // Working memory of the reconstruction, kept between frames.
  std::vector<glm::vec4> weighted;  ///< Σ weight·(r, g, b, 1), one a pixel
  std::vector<float> nearest;       ///< disparity of the surface that is nearest so far; 0: none
  std::vector<glm::ivec2> spans;    ///< the region's columns, one a row

  void resize(int width, int height);
};

struct WarpCounts {
  std::size_t samples = 0;           ///< warped
  std::size_t samples_clipped = 0;   ///< left out because they cannot fall into the region
  std::size_t pixels = 0;            ///< in the region
  std::size_t pixels_uncovered = 0;  ///< of them, those into which no sample fell
  std::size_t pixels_bridged = 0;    ///< of the uncovered, cracks within a surface that were closed
};

struct WarpOptions {
  bool clip = true;  ///< leave out tiles that cannot fall into the region: the same picture, sooner
  int threads = 0;   ///< [≥ 0] 0: as many as TBB has
};

/// Warps every sample of `images` (each after the one before it: of reference images the farther
/// ones first) that falls into `region` (a convex polygon in the target's pixels, row 0 on top)
/// into `target`, whose pixels there are first cleared; no other pixel is written.
/// Occlusion-compatible order within an image, in 4, 2 or 1 sheets. `desired` has the target's
/// size.  The same pixels for any number of threads: each warps the rows of its own.  Never
/// allocates once `target` has its size, but for what TBB keeps. Source: McMillan & Bishop,
/// Plenoptic Modeling, 1995; sheets as in Rafferty et al. 1998, sec. 3.1.
WarpCounts warpImages(std::span<const Ldi* const> images, const PlanarCamera& desired,
                      std::span<const glm::vec2> region, WarpBuffer& target,
                      const WarpOptions& options = {}) noexcept;

/// The same for one image.
WarpCounts warpLdi(const Ldi& ldi, const PlanarCamera& desired, std::span<const glm::vec2> region,
                   WarpBuffer& target, const WarpOptions& options = {}) noexcept;

}  // namespace enfilade
