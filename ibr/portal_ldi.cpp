#include "ibr/portal_ldi.h"

#include <cassert>

namespace enfilade {

PortalLdi::PortalLdi(const Portal& portal, bool from_front, float eye_y,
                     const ImageParameters& parameters)
    : portal_(portal),
      from_front_(from_front),
      parameters_(parameters),
      viewpoints_(captureViewpoints(portal, from_front, eye_y, parameters)),
      central_(viewpoints_.empty()
                   ? PlanarCamera()
                   : portalCamera(portal, from_front, viewpoints_.front(), parameters)),
      builder_(central_, {parameters.depth_threshold, parameters.ldi_half_width}) {}

void PortalLdi::captureNext(const CaptureFunction& capture) {
  assert(!complete());
  const PlanarCamera camera =
      portalCamera(portal_, from_front_, viewpoints_[captured_], parameters_);
  const float threshold = disparityThreshold(central_, parameters_.depth_threshold);
  const CaptureSamples samples =
      samplesThroughPortal(capture(refined(camera, parameters_.rays)), portal_,
                           parameters_.portal_margin, parameters_.rays, threshold);
  builder_.insert(samples);
  samples_ += samples.samples.size();
  ++captured_;
}

Ldi PortalLdi::finish() const { return viewpoints_.empty() ? Ldi() : builder_.finish(); }

}  // namespace enfilade
