// Rafferty et al., Images for Accelerating Architectural Walkthroughs, 1998, sec. 4.
#include <algorithm>
#include <cmath>

#include "ibr/portal_capture.h"
#include "ibr/portal_frame.h"

namespace enfilade {
namespace {

/// Half the axes of the semicircle: to the side, and ahead [m].
glm::dvec2 ringAxes(const PortalFrame& frame, const ImageParameters& parameters) {
  const auto radius = static_cast<double>(parameters.switch_distance);
  return {std::max(radius, frame.half_width + 0.5 * radius), radius};
}

/// Columns and rows of an image of the portal, the larger ones within kMostPixels.
glm::dvec2 pixelsOf(const PortalFrame& frame, int image_size) {
  const glm::dvec2 size = 2.0 * glm::dvec2(frame.half_width, frame.half_height);
  const glm::dvec2 pixels = image_size / ImageParameters::kDoorHeight * size;
  return pixels * std::min(1.0, ImageParameters::kMostPixels / std::max(pixels.x, pixels.y));
}

std::vector<glm::dvec3> viewpointsOnRing(const PortalFrame& frame, const glm::dvec2& axes,
                                         double eye_y, const CaptureRing& ring) {
  const glm::dvec3 ahead = levelAhead(frame);
  std::vector<glm::dvec3> viewpoints;
  for (int i = 0; i < ring.captures; ++i) {
    const double along = ring.captures == 1 ? 0.0 : 2.0 * i / (ring.captures - 1) - 1.0;
    const double angle = glm::radians(along * static_cast<double>(ring.angle));
    glm::dvec3 at =
        frame.center + axes.x * std::sin(angle) * frame.right + axes.y * std::cos(angle) * ahead;
    at.y = eye_y + static_cast<double>(ring.above_eye);
    viewpoints.push_back(at);
  }
  return viewpoints;
}

}  // namespace

bool canShowImages(const Portal& portal) {
  if (portal.polygon.size() < 3 || std::abs(portal.plane.normal.y) > 0.5f) {
    return false;
  }
  const PortalFrame frame = portalFrame(portal, true);
  return frame.half_width >= 0.1 && frame.half_height >= 0.1;
}

std::vector<glm::dvec3> semicircleViewpoints(const Portal& portal, bool from_front, float eye_y,
                                             const ImageParameters& parameters,
                                             const CaptureRing& ring) {
  const PortalFrame frame = portalFrame(portal, from_front);
  return viewpointsOnRing(frame, ringAxes(frame, parameters), static_cast<double>(eye_y), ring);
}

std::vector<glm::dvec3> captureViewpoints(const Portal& portal, bool from_front, float eye_y,
                                          const ImageParameters& parameters) {
  const PortalFrame frame = portalFrame(portal, from_front);
  std::vector<glm::dvec3> viewpoints =
      semicircleViewpoints(portal, from_front, eye_y, parameters, {1, 0.0f, 0.0f});
  for (const CaptureRing& plan : parameters.rings) {
    std::vector<glm::dvec3> ring =
        semicircleViewpoints(portal, from_front, eye_y, parameters, plan);
    std::stable_sort(ring.begin(), ring.end(), [&](const glm::dvec3& a, const glm::dvec3& b) {
      // To the micrometre, so that rounding does not decide between left and right.
      const auto aside = [&](const glm::dvec3& p) {
        return std::round(1e6 * std::abs(glm::dot(p - frame.center, frame.right)));
      };
      return aside(a) < aside(b);
    });
    for (const glm::dvec3& at : ring) {
      if (glm::distance(at, viewpoints.front()) > 1e-6) {
        viewpoints.push_back(at);
      }
    }
  }
  std::erase_if(viewpoints, [&](const glm::dvec3& at) { return !standsBefore(frame, at); });
  return viewpoints;
}

PlanarCamera portalCamera(const Portal& portal, bool from_front, const glm::dvec3& viewpoint,
                          const ImageParameters& parameters, double widen) {
  PortalFrame frame = portalFrame(portal, from_front);
  frame.half_width += static_cast<double>(parameters.portal_margin);
  frame.half_height += static_cast<double>(parameters.portal_margin);
  const glm::dvec2 pixels = widen * pixelsOf(frame, parameters.image_size);
  PlanarCamera camera;
  camera.center = viewpoint;
  camera.width = static_cast<int>(std::max(std::round(pixels.x), 1.0));
  camera.height = static_cast<int>(std::max(std::round(pixels.y), 1.0));
  const glm::dvec3 right = widen * frame.half_width * frame.right;
  const glm::dvec3 up = widen * frame.half_height * frame.up;
  camera.world_from_pixel = glm::dmat3(2.0 / camera.width * right, -2.0 / camera.height * up,
                                       frame.center - right + up - viewpoint);
  return camera;
}

}  // namespace enfilade
