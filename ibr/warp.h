#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>

#include "ibr/ldi.h"
#include "ibr/planar_camera.h"
#include "ibr/splat.h"
#include "scene/image.h"

namespace enfilade {

class ThreadTeam;
struct WarpScratch;

/// Alpha of a warped picture's pixels: 0 where no sample fell.
inline constexpr std::uint8_t kAlphaOfSample = 255;
inline constexpr std::uint8_t kAlphaOfFilling = 254;  ///< no sample fell there, but it was filled

/// The frame-sized picture that images are warped into.
class WarpBuffer {
 public:
  /// `scratch`: working memory that many buffers may share; without it the buffer has its own.
  explicit WarpBuffer(std::shared_ptr<WarpScratch> scratch = nullptr);

  void resize(int width, int height);
  WarpScratch& scratch() noexcept { return *scratch_; }

  Image color;

 private:
  std::shared_ptr<WarpScratch> scratch_;
};

struct WarpCounts {
  std::size_t samples = 0;           ///< warped
  std::size_t samples_clipped = 0;   ///< left out because they cannot fall into the region
  std::size_t pixels = 0;            ///< in the region
  std::size_t pixels_uncovered = 0;  ///< of them, those into which no sample fell
  std::size_t pixels_bridged = 0;    ///< of the uncovered, cracks within a surface that were closed

  WarpCounts& operator+=(const WarpCounts& more) noexcept;
};

/// Which samples are left out before they are warped.  The picture is the same with any.
enum class Clip : std::uint8_t {
  kNothing,
  kColumns,  ///< whole columns of tiles, recursively (Popescu et al. 1998)
  kTiles     ///< each tile by itself, which leaves out more
};

struct WarpOptions {
  Splat splat = Splat::kMean;
  Clip clip = Clip::kTiles;
  ThreadTeam* team = nullptr;  ///< who warps; null: the calling thread
};

/// A region of a picture that images are to be warped into.
struct WarpJob {
  std::span<const Ldi* const> images;  ///< of reference images the farther ones first
  std::span<const glm::vec2> region;   ///< a convex polygon [pixels, row 0 on top], any winding
  WarpBuffer* target = nullptr;        ///< may be that of other jobs whose regions it does not meet
  WarpCounts counts;                   ///< filled in
};

/// Warps every sample of every job's images, each image after the one before it, that falls into
/// the job's region into its target, whose pixels there are first cleared; no other pixel is
/// written. Occlusion-compatible order within an image, in 4, 2 or 1 sheets.  `desired` has the
/// targets' size. The same pixels for any number of threads: each has a fragment of a region to get
/// right, and warps all that may fall there.  Never allocates once the targets' scratch has seen
/// warps as large and as many. Source: McMillan & Bishop, Plenoptic Modeling, 1995; sheets and
/// fragments as in Rafferty et al. 1998, sec. 3.1.
void warpJobs(std::span<WarpJob> jobs, const PlanarCamera& desired,
              const WarpOptions& options = {}) noexcept;

/// The same for one region.
WarpCounts warpImages(std::span<const Ldi* const> images, const PlanarCamera& desired,
                      std::span<const glm::vec2> region, WarpBuffer& target,
                      const WarpOptions& options = {}) noexcept;

/// The same for one image.
WarpCounts warpLdi(const Ldi& ldi, const PlanarCamera& desired, std::span<const glm::vec2> region,
                   WarpBuffer& target, const WarpOptions& options = {}) noexcept;

}  // namespace enfilade
