#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "preprocess/walk_columns.h"

namespace enfilade {

/// The distance from `p` to the triangle [m].  Source: Ericson, Real-Time Collision Detection,
/// 2005, 5.1.5.
double distanceToTriangle(const glm::dvec3& p, const WorldTriangle& triangle) noexcept;

/// Whether the segment meets the triangle, its rim included.  Parallel ones do not meet.
bool segmentMeetsTriangle(const glm::dvec3& a, const glm::dvec3& b,
                          const WorldTriangle& triangle) noexcept;

/// The triangles that a walker cannot pass, sorted into upright square bins: exact distances and
/// crossings, near the walker only.
class ObstacleBins {
 public:
  explicit ObstacleBins(const House& house, float bin = 0.5f);

  /// The distance from `p` to the nearest triangle, or `most` if that is less.
  float distance(const glm::vec3& p, float most) const;

  /// Whether the segment crosses a triangle.
  bool crosses(const glm::vec3& a, const glm::vec3& b) const;

 private:
  glm::ivec2 binOf(const glm::vec2& p) const noexcept;  ///< clamped to the grid
  template <typename Visit>
  void forEachIn(const glm::vec2& least, const glm::vec2& most, const Visit& visit) const;

  float bin_;
  glm::vec2 origin_{0};
  glm::ivec2 size_{0};
  std::vector<WorldTriangle> triangles_;
  std::vector<std::uint32_t> first_;  ///< a bin's first entry; one more than bins
  std::vector<std::uint32_t> entries_;
};

}  // namespace enfilade
