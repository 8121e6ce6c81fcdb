#pragma once

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/geometry.h"

namespace enfilade {

/// A convex polygon of view directions from the eye: what can be seen through a chain of portals.
/// Kept as the polygon's corners in normalised device coordinates, counter-clockwise, with the
/// planes through the eye that bound the view volume behind it (inside ≥ 0).
struct ScreenRegion {
  std::vector<glm::vec2> corners;  ///< NDC, −1…1
  std::vector<Plane> planes;       ///< world, one an edge, through the eye

  bool empty() const noexcept { return corners.size() < 3; }
};

/// The whole screen of `view`.
ScreenRegion wholeScreen(const View& view);

/// The part of `region` behind `polygon` (world, convex, any winding).  Empty if none.  Exact but
/// for rounding, for which the result is widened by `slack_ndc`: conservative, draws more, never
/// less.
ScreenRegion clipRegion(const View& view, const ScreenRegion& region,
                        std::span<const glm::vec3> polygon, float slack_ndc = 1e-4f);

/// Whether any point of `box` may lie in the view volume of `region`: conservative.
bool mayBeSeen(const ScreenRegion& region, const Box& box) noexcept;

}  // namespace enfilade
