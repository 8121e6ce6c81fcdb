#pragma once

#include <span>

#include "app/view/theme.h"
#include "portals/house.h"
#include "scene/camera.h"
#include "visibility/portal_culling.h"

namespace enfilade {

/// Draws things that stand in the world over the picture that a camera sees of it, through walls.
class WorldMarks {
 public:
  /// `box`: of the window, that the picture fills.  All must outlive it.
  WorldMarks(OverlayPainter& overlay, const Theme& theme, const Camera& camera,
             const PixelBox& box);

  /// The outlines of all portals, in the colours of what they show to `seen`.
  void portals(const CellGraph& graph, const VisibleSet& seen);

  /// The names of the cells that are seen, or of all if the frame did not look for cells.
  void names(const CellGraph& graph, const VisibleSet& seen);

  /// The edges of what a camera sees up to `far` [m].
  void frustum(const Camera& camera, float far);

  void line(const glm::vec3& from, const glm::vec3& to, float width, const OverlayColor& color);

 private:
  glm::vec2 toPixel(const glm::dvec4& clip) const;

  OverlayPainter& overlay_;
  const Theme& theme_;
  PixelBox box_;
  glm::dmat4 clip_from_world_;
  double near_;
};

}  // namespace enfilade
