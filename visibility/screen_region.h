#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "scene/camera.h"
#include "scene/geometry.h"

namespace enfilade {

/// Regions are widened by this much [NDC]: more than the rounding of positions in single precision
/// and of a rasteriser's sub-pixel grid; a third of a pixel in a picture 640 wide.
inline constexpr float kScreenSlack = 1e-3f;

/// A convex polygon of view directions from the eye: what can be seen through a chain of portals.
/// Kept as the polygon's corners in normalised device coordinates, counter-clockwise, with the
/// planes through the eye that bound the view volume behind it (inside ≥ 0).
struct ScreenRegion {
  std::vector<glm::vec2> corners;  ///< NDC, −1…1
  std::vector<Plane> planes;       ///< world, unit normals, one an edge, through the eye

  bool empty() const noexcept { return corners.size() < 3; }
};

/// The shadow of a polygon on the screen: what it leaves of any region.
struct ScreenClip {
  enum class Kind { kNothing, kEverything, kPart };
  Kind kind = Kind::kNothing;
  std::vector<glm::dvec3> half_planes;  ///< of kPart: x · NDC.x + y · NDC.y + z ≥ 0 is inside
};

/// The whole screen of `view`.
ScreenRegion wholeScreen(const View& view);

/// The shadow of `polygon` (world, planar and convex within rounding, any winding), of the part of
/// it that lies before the eye, widened by `slack_ndc`.  Everything, if the eye is on the polygon.
ScreenClip screenClip(const View& view, std::span<const glm::vec3> polygon,
                      float slack_ndc = kScreenSlack);

/// The part of `region` within `clip`.  Empty if none.
ScreenRegion clipRegion(const View& view, const ScreenRegion& region, const ScreenClip& clip);

/// The part of `region` behind `polygon`: by its shadow.  Exact but for rounding, for which it is
/// widened: conservative, draws more, never less.
ScreenRegion clipRegion(const View& view, const ScreenRegion& region,
                        std::span<const glm::vec3> polygon, float slack_ndc = kScreenSlack);

/// The smallest upright rectangle around all of `regions`.
ScreenRegion boundingRegion(const View& view, std::span<const ScreenRegion> regions);

/// Whether `inner` lies within `outer`, but for rounding far below the slack.
bool contains(const ScreenRegion& outer, const ScreenRegion& inner) noexcept;

/// Whether any point of `box` may lie in the view volume of `region`: conservative.  An empty box
/// is never seen.
bool mayBeSeen(const ScreenRegion& region, const Box& box) noexcept;

/// Whether any point of `box` may lie on the inner side of every one of `planes`: conservative.
bool mayTouch(std::span<const Plane> planes, const Box& box) noexcept;

}  // namespace enfilade
