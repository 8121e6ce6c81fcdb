#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace enfilade {

/// A window in squares of pixels, each with a depth that a surface drawn all over it is nearer than
/// for sure.  What lies behind that in every square that it touches is hidden, in whichever order
/// all is drawn under a depth test.
/// Source: Greene, Kass & Miller, Hierarchical Z-Buffer Visibility, 1993; Zhang et al., Visibility
/// Culling Using Hierarchical Occlusion Maps, 1997.
class OcclusionGrid {
 public:
  static constexpr int kSide = 8;  ///< of a square [pixels]

  /// A corner in homogeneous window coordinates: x / w and y / w are pixels, w > 0 before the eye.
  using Corners = std::array<glm::dvec3, 3>;

  /// Empties the grid for a window of this size.  Allocates only when the size grows.
  void start(int width, int height);

  /// What is known of how exactly a triangle is drawn.
  struct Limits {
    double slack = 0;    ///< [pixels] that its edges may be off by
    double nearest = 0;  ///< 1 / w: what is nearer may be cut off
    double factor = 1;  ///< its depth, 1 / w, is drawn no farther than `factor` · 1 / w − `less`
    double less = 0;
  };

  /// A triangle that will be drawn, opaque, on rows `first`…`last` of pixels at most; it may be
  /// wound either way, and may reach behind the eye.
  void add(const Corners& corners, const Limits& limits, int first, int last) noexcept;

  /// Whether something no nearer than `nearest` (1 / w) that covers pixels of columns x0…x1 and
  /// rows y0…y1 at most is hidden.
  bool hides(int x0, int y0, int x1, int y1, float nearest) const noexcept;

 private:
  int columns_ = 0;  // of squares; those that reach over the window's edge count
  int rows_ = 0;
  std::vector<float> depth_;  // 1 / w, row by row; 0: nothing
};

}  // namespace enfilade
