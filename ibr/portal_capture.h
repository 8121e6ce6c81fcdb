#pragma once

#include <functional>
#include <vector>

#include "ibr/depth_image.h"
#include "ibr/image_parameters.h"
#include "ibr/ldi.h"
#include "portals/cell_graph.h"
#include "render/renderer.h"

namespace enfilade {

/// The objects to draw for a view, increasing.
using ObjectsInView = std::function<std::vector<std::uint32_t>(const View& view)>;

/// Whether a portal can show images at all: upright (within 30° of vertical) and of some size.
bool canShowImages(const Portal& portal);

/// Viewpoints on the semicircle of radius `parameters.switch_distance` before the portal's centre,
/// at height `eye_y`, from one side to the other; an odd count has the central one in the middle.
/// Source: Rafferty et al. 1998, sec. 4.
std::vector<glm::dvec3> semicircleViewpoints(const Portal& portal, bool from_front, float eye_y,
                                             const ImageParameters& parameters);

/// The planar camera at `viewpoint` whose image plane is the portal's own and whose window is the
/// portal's bounding rectangle, widened about its centre by `widen` (1: just the portal).
PlanarCamera portalCamera(const Portal& portal, bool from_front, const glm::dvec3& viewpoint,
                          const ImageParameters& parameters, double widen = 1.0);

/// What is seen through a portal from a viewpoint: colour and disparity.  Draws only what lies
/// behind the portal's plane.
DepthImage captureThroughPortal(Renderer& renderer, const PlanarCamera& camera,
                                const ObjectsInView& objects, double far_depth);

/// The layered depth image of a portal's side from its captures along the semicircle.
Ldi bakeLdi(Renderer& renderer, const Portal& portal, bool from_front, float eye_y,
            const ImageParameters& parameters, const ObjectsInView& objects, double far_depth);

}  // namespace enfilade
