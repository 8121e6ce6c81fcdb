#pragma once

#include <functional>
#include <vector>

#include "ibr/capture_samples.h"
#include "ibr/depth_image.h"
#include "ibr/image_parameters.h"
#include "ibr/ldi.h"
#include "portals/cell_graph.h"
#include "render/renderer.h"

namespace enfilade {

/// The objects to draw for a view, increasing.
using ObjectsInView = std::function<std::vector<std::uint32_t>(const View& view)>;

/// Whether a portal can show images at all: upright (within 30° of vertical) and of some size (0.2
/// m wide and high).
bool canShowImages(const Portal& portal);

/// The viewpoints of `ring` on the semicircle of radius `parameters.switch_distance` before the
/// middle of the portal's bounding rectangle, from left to right as the viewer sees it, at their
/// height above `eye_y` [m, world]; an odd count has the central one in the middle.  Before a wide
/// portal it is half an ellipse that goes around the portal, so that every horizontal line of sight
/// through the portal from an eye farther than the switch distance from its nearest point crosses
/// it. Source: Rafferty et al. 1998, sec. 4.
std::vector<glm::dvec3> semicircleViewpoints(const Portal& portal, bool from_front, float eye_y,
                                             const ImageParameters& parameters,
                                             const CaptureRing& ring);

/// Every viewpoint that an LDI is made from: the central one first, then ring after ring of
/// `parameters.rings`, each from the middle outward.  Those that would not stand before the
/// portal's plane (by 5 cm) are left out.
std::vector<glm::dvec3> captureViewpoints(const Portal& portal, bool from_front, float eye_y,
                                          const ImageParameters& parameters);

/// The planar camera at `viewpoint` whose image plane is the portal's own and whose window is the
/// bounding rectangle of the portal and its margin, widened about its centre by `widen` (1: just
/// that).
PlanarCamera portalCamera(const Portal& portal, bool from_front, const glm::dvec3& viewpoint,
                          const ImageParameters& parameters, double widen = 1.0);

/// What is seen through a portal from a viewpoint: colour and disparity.  Draws only what lies
/// behind the portal's plane.  Textures are as smooth as in a picture in which `rays` × `rays`
/// pixels are one.  Throws Error (kMachine) when the picture is too large.
DepthImage captureThroughPortal(Renderer& renderer, const PlanarCamera& camera,
                                const ObjectsInView& objects, double far_depth, int rays = 1);

/// What a planar camera with its image plane in a portal sees of what lies behind the portal.
using CaptureFunction = std::function<DepthImage(const PlanarCamera& camera)>;

/// Sets δ = 0 in the pixels of a capture that look past the portal by more than the margin [m].
void maskBeyondMargin(DepthImage& image, const Portal& portal, float margin);

/// The samples of a capture of `rays` × `rays` pixels for one of the LDI's (see resolveCapture());
/// what is seen past the portal's edge, within the margin [m], is doubted.
CaptureSamples samplesThroughPortal(DepthImage fine, const Portal& portal, float margin, int rays,
                                    float threshold);

/// The layered depth image of a portal's side: PortalLdi with every capture.
Ldi buildLdi(const Portal& portal, bool from_front, float eye_y, const ImageParameters& parameters,
             const CaptureFunction& capture);

/// buildLdi() with captures by `renderer`.  The same bytes run after run.  Throws Error (kMachine)
/// when a capture is too large for the machine.
Ldi bakeLdi(Renderer& renderer, const Portal& portal, bool from_front, float eye_y,
            const ImageParameters& parameters, const ObjectsInView& objects, double far_depth);

}  // namespace enfilade
