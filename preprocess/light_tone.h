#pragma once

#include <glm/glm.hpp>
#include <span>

#include "preprocess/light_gather.h"

namespace enfilade {

/// From illuminance to a vertex colour, which ends at 1: 1 − exp(−exposure · E) of the luminance,
/// the hue kept.
struct LightTone {
  float exposure = 1;  ///< [1/lx] > 0

  /// Linear, 0…1.
  glm::vec3 shade(const glm::vec3& light) const noexcept;
};

/// The tone that makes the median, by area, of what is indoors `mid_tone`; of everything, if
/// nothing lit is indoors.  Exposure 0 if nothing is lit at all.
LightTone toneFor(const LightPoints& points, const GatheredLight& gathered,
                  std::span<const glm::vec3> light, float mid_tone);

/// Of linear RGB, as the eye weighs it (Rec. 709).
inline float luminance(const glm::vec3& rgb) noexcept {
  return glm::dot(rgb, glm::vec3(0.2126f, 0.7152f, 0.0722f));
}

}  // namespace enfilade
