#include "ibr/portal_capture.h"

#include <algorithm>

#include "ibr/ldi_builder.h"
#include "ibr/portal_window.h"
#include "portals/polygon.h"

namespace enfilade {

DepthImage captureThroughPortal(Renderer& renderer, const PlanarCamera& camera,
                                const ObjectsInView& objects, double far_depth) {
  const View view = viewOf(camera, far_depth);
  renderer.begin(camera.width, camera.height);
  renderer.draw(objects(view), view);
  renderer.finish();

  DepthImage image;
  image.camera = camera;
  renderer.readColor(image.color);
  renderer.readDepth(image.disparity);
  const double near = imagePlaneDistance(camera);
  for (float& pixel : image.disparity) {
    pixel = disparityFromDepth(pixel, near, far_depth);
  }
  return image;
}

namespace {

/// Of what is seen past the portal's edge much is the wall's inside: it yields to what is seen
/// through the portal.
constexpr float kDoubtBesideThePortal = 1e4f;

/// Sets δ = 0 in the pixels of a capture that look past the portal by more than the margin.
void maskBeyondMargin(DepthImage& image, const Portal& portal, float margin) {
  const std::vector<glm::ivec2> spans =
      pixelsThrough(grownPolygon(portal.polygon, portal.plane, margin), image.camera);
  const auto width = static_cast<std::size_t>(image.camera.width);
  for (std::size_t y = 0; y < spans.size(); ++y) {
    float* const row = image.disparity.data() + y * width;
    std::fill(row, row + spans[y].x, 0.0f);
    std::fill(row + spans[y].y, row + width, 0.0f);
  }
}

void doubtBesidePortal(CaptureSamples& capture, const Portal& portal) {
  const std::vector<glm::ivec2> through = pixelsThrough(portal.polygon, capture.camera);
  for (CaptureSample& s : capture.samples) {
    const glm::ivec2 span = through[static_cast<std::size_t>(s.v)];
    const int column = static_cast<int>(s.u);
    s.doubt = span.x <= column && column < span.y ? 1.0f : kDoubtBesideThePortal;
  }
}

}  // namespace

Ldi buildLdi(const Portal& portal, bool from_front, float eye_y, const ImageParameters& parameters,
             const CaptureFunction& capture) {
  const std::vector<glm::dvec3> viewpoints =
      captureViewpoints(portal, from_front, eye_y, parameters);
  if (viewpoints.empty()) {
    return {};
  }
  const PlanarCamera central = portalCamera(portal, from_front, viewpoints.front(), parameters);
  const float threshold = disparityThreshold(central, parameters.depth_threshold);
  LdiBuilder builder(central, {parameters.depth_threshold, parameters.ldi_half_width});
  for (const glm::dvec3& viewpoint : viewpoints) {
    const PlanarCamera camera = portalCamera(portal, from_front, viewpoint, parameters);
    DepthImage fine = capture(refined(camera, parameters.rays));
    maskBeyondMargin(fine, portal, parameters.portal_margin);
    CaptureSamples samples = resolveCapture(fine, parameters.rays, threshold);
    doubtBesidePortal(samples, portal);
    builder.insert(samples);
  }
  return builder.finish();
}

Ldi bakeLdi(Renderer& renderer, const Portal& portal, bool from_front, float eye_y,
            const ImageParameters& parameters, const ObjectsInView& objects, double far_depth) {
  return buildLdi(portal, from_front, eye_y, parameters, [&](const PlanarCamera& camera) {
    return captureThroughPortal(renderer, camera, objects, far_depth);
  });
}

}  // namespace enfilade
