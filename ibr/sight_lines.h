#pragma once

#include <optional>
#include <vector>

#include "ibr/portal_capture.h"
#include "ibr/warp_transform.h"
#include "render/ray_caster.h"

namespace enfilade {

/// A point on a ray of the central view.
struct RayPoint {
  double u = 0, v = 0;     ///< pixels of the central view
  double disparity = 0;    ///< in it
  glm::dvec3 normal{0};    ///< of the surface, of any length; 0: the sky
  bool one_sided = false;  ///< the surface is seen from the front of its normal only
};

/// The viewpoints before a portal, and what they see through it of points in the central view.
class SightLines {
 public:
  /// `central`: the camera whose pixels the points are given in.  The captures' pixels have `rays`
  /// × `rays` rays, as `parameters` say.  Keeps a reference to `caster`.
  SightLines(const RayCaster& caster, const PlanarCamera& central,
             const std::vector<glm::dvec3>& viewpoints, const Portal& portal, bool from_front,
             const ImageParameters& parameters, double far_depth);

  /// The viewpoint that sees the point best, or none that does: the central one, number 0, if it
  /// sees it; otherwise the one whose pixel covers the least of the surface there.
  std::optional<std::size_t> bestEye(const RayPoint& point) const;

  /// What that viewpoint sees at the point, if it sees it: a picture's colour.
  std::optional<glm::u8vec3> colorFrom(std::size_t eye, const RayPoint& point) const;

 private:
  struct Eye {
    PlanarCamera camera;  ///< of the capture's single rays
    WarpTransform from_central;
    double most = 0;                    ///< [distances to the image plane] of what it sees
    std::vector<glm::ivec2> through;    ///< pixels that look through the portal
    std::vector<glm::ivec2> by_margin;  ///< … or its margin
  };
  struct Place {
    glm::dvec3 direction;  ///< of the eye's ray through the point
    double distance = 0;   ///< along it; < 0: the eye does not look there
    bool beside = false;   ///< past the portal, through its margin
  };
  Place placeIn(const Eye& eye, const RayPoint& point) const noexcept;

  const RayCaster& caster_;
  std::vector<Eye> eyes_;
};

}  // namespace enfilade
