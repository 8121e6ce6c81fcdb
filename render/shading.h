#pragma once

#include <glm/glm.hpp>

namespace enfilade {

/// The sky and sun term of a unit world normal, in display (gamma) space: the displayed colour is
/// texel × tint × skyAndSun(n), where `tint` is encodeTint(base colour × vertex colour).
/// Gamma-encoded products are encoded products, so nothing is decoded per pixel.  The shader in
/// renderer_shaders.cpp computes the same.
float skyAndSun(const glm::vec3& normal) noexcept;

/// Linear to display, the 2.2 power law; alpha as it is.
glm::vec4 encodeTint(const glm::vec4& linear) noexcept;

}  // namespace enfilade
