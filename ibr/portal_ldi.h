#pragma once

#include "ibr/ldi_builder.h"
#include "ibr/portal_capture.h"

namespace enfilade {

/// The layered depth image of a portal's side in the making, a capture at a time: at
/// captureViewpoints(), the central one first, `rays` × `rays` pixels of a capture for one of the
/// LDI's.  What a capture sees past the portal's edge, within the margin, gives way to what is seen
/// through the portal.
class PortalLdi {
 public:
  PortalLdi(const Portal& portal, bool from_front, float eye_y, const ImageParameters& parameters);

  std::size_t captures() const noexcept { return viewpoints_.size(); }  ///< in all
  std::size_t captured() const noexcept { return captured_; }           ///< so far
  bool complete() const noexcept { return captured_ == viewpoints_.size(); }
  std::size_t samplesCaptured() const noexcept { return samples_; }

  /// Takes the next capture and inserts it.  Not to be called when complete.
  void captureNext(const CaptureFunction& capture);

  /// The layered depth image of what was captured so far.
  Ldi finish() const;

 private:
  Portal portal_;
  bool from_front_;
  ImageParameters parameters_;
  std::vector<glm::dvec3> viewpoints_;
  PlanarCamera central_;
  LdiBuilder builder_;
  std::size_t captured_ = 0;
  std::size_t samples_ = 0;
};

}  // namespace enfilade
