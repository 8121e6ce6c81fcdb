#pragma once

#include <glm/glm.hpp>

namespace enfilade {

/// The sky and sun term of a unit world normal, in display (gamma) space, 0…1: the displayed colour
/// is texel × tint × skyAndSun(n), where `tint` is encodeTint(base colour × vertex colour).
/// Gamma-encoded products are encoded products, so nothing is decoded per pixel.  Tint and term do
/// not depend on the viewpoint, so their product is worked out once a vertex (world_geometry.h).
float skyAndSun(const glm::vec3& normal) noexcept;

/// Linear to display, the 2.2 power law; alpha as it is.  Clamped to 0…1.
glm::vec4 encodeTint(const glm::vec4& linear) noexcept;

}  // namespace enfilade
