#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/occlusion_grid.h"
#include "render/sieve_view.h"
#include "render/triangle_sieve_kernel.h"
#include "render/world_geometry.h"

namespace enfilade {

/// An object to be drawn.
struct SieveObject {
  std::uint32_t object = 0;
  bool double_sided = false;
  bool opaque = true;  ///< hides what is behind it
};

/// Leaves out the triangles that change no pixel: those off the window, those seen from behind,
/// those that miss every pixel's centre, and those behind a large triangle.  Without a GPU each
/// would cost OpenGL more than finding that out.  Conservative: what OpenGL might show is kept,
/// whatever the order, so that the picture is the same to the last bit.
class TriangleSieve {
 public:
  explicit TriangleSieve(const WorldGeometry& world);

  /// Finds what is to be drawn of `objects`.  `indices()` and `range()` tell it until the next
  /// call.  Keeps its memory for the next.  The same for any number of
  /// `threads`; 0: as many as oneTBB may use.
  void sift(std::span<const SieveObject> objects, const SieveView& view, int threads = 0);

  /// Three a triangle, in the order of `objects` and of each one's triangles.
  std::span<const std::uint32_t> indices() const noexcept { return {indices_.data(), used_}; }

  /// Those of an object of the last call.
  const IndexRange& range(std::uint32_t object) const noexcept { return ranges_[object]; }

 private:
  struct Extent {
    std::size_t first = 0;  // triangle
    std::size_t count = 0;
    glm::vec3 reach{0};  // the greatest |x|, |y| and |z| [m]
  };
  /// Some triangles of one object, sifted at once.
  struct Piece {
    const SieveObject* object = nullptr;
    std::size_t first = 0;  // triangle
    std::size_t count = 0;
    std::size_t slot = 0;  // of the first, among those kept
    std::size_t kept = 0;
    SieveRows rows;
    float depth_rounding = 0;  // see depthRounding
  };
  void plan(std::span<const SieveObject> objects);
  SieveOutput output(std::size_t slot) noexcept;
  void addOccluders(const Piece& piece) noexcept;
  void write(const Piece& piece) noexcept;

  std::vector<std::uint32_t> world_indices_;
  std::vector<float> coordinates_;  // nine arrays
  TriangleCorners corners_;
  std::vector<Extent> extents_;  // one an object

  // Of the call at hand, kept for their memory.
  SieveView view_;
  DepthRange depths_;
  std::vector<Piece> pieces_;
  std::size_t slots_ = 0;  // those of all pieces
  std::vector<std::uint32_t> kept_;
  std::vector<std::int32_t> boxes_;  // x0, y0, x1, y1: four arrays
  std::vector<float> nearest_;
  OcclusionGrid grid_;
  std::vector<std::uint32_t> indices_;
  std::size_t used_ = 0;
  std::vector<IndexRange> ranges_;  // one an object
};

}  // namespace enfilade
