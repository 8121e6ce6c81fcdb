#include "ibr/portal_capture.h"

#include <algorithm>
#include <cmath>

#include "ibr/portal_ldi.h"
#include "ibr/portal_window.h"
#include "portals/polygon.h"

namespace enfilade {

DepthImage captureThroughPortal(Renderer& renderer, const PlanarCamera& camera,
                                const ObjectsInView& objects, double far_depth, int rays) {
  const View view = viewOf(camera, far_depth);
  renderer.begin(camera.width, camera.height);
  renderer.setTextureBias(std::log2(static_cast<float>(rays)));
  renderer.draw(objects(view), view);
  renderer.setTextureBias(0.0f);
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

void doubtBesidePortal(CaptureSamples& capture, const Portal& portal) {
  const std::vector<glm::ivec2> through = pixelsThrough(portal.polygon, capture.camera);
  for (CaptureSample& s : capture.samples) {
    const glm::ivec2 span = through[static_cast<std::size_t>(s.v)];
    const int column = static_cast<int>(s.u);
    s.doubt =
        span.x <= column && column < span.y ? 1.0f : static_cast<float>(kDoubtBesideThePortal);
  }
}

}  // namespace

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

CaptureSamples samplesThroughPortal(DepthImage fine, const Portal& portal, float margin, int rays,
                                    float threshold) {
  maskBeyondMargin(fine, portal, margin);
  CaptureSamples samples = resolveCapture(fine, rays, threshold);
  doubtBesidePortal(samples, portal);
  return samples;
}

Ldi buildLdi(const Portal& portal, bool from_front, float eye_y, const ImageParameters& parameters,
             const CaptureFunction& capture) {
  PortalLdi ldi(portal, from_front, eye_y, parameters);
  while (!ldi.complete()) {
    ldi.captureNext(capture);
  }
  return ldi.finish();
}

Ldi bakeLdi(Renderer& renderer, const Portal& portal, bool from_front, float eye_y,
            const ImageParameters& parameters, const ObjectsInView& objects, double far_depth) {
  return buildLdi(portal, from_front, eye_y, parameters, [&](const PlanarCamera& camera) {
    return captureThroughPortal(renderer, camera, objects, far_depth, parameters.rays);
  });
}

}  // namespace enfilade
