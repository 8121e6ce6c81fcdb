#include "render/sieve_view.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kUnit = 0x1p-24f;  // rounding of a single-precision sum, relative to its terms

/// The sum of the magnitudes of row · (p, 1), of which it may be off by 4 units, and OpenGL's by as
/// many the other way.
float magnitude(const glm::vec4& row, const glm::vec3& reach) {
  return glm::dot(glm::abs(row), glm::vec4(reach, 1));
}

}  // namespace

SieveRows sieveRows(const SieveView& view, const glm::vec3& reach, bool drops_counter) noexcept {
  const glm::mat4 rows = glm::transpose(view.clip_from_world);
  const glm::vec2 half = 0.5f * glm::vec2(view.width, view.height);
  SieveRows result;
  result.x = half.x * (rows[0] + rows[3]);
  result.y = half.y * (rows[1] + rows[3]);
  result.w = rows[3];
  result.last = 2.0f * half - 1.0f;
  // Of x and w before the divide; twice as much again for the divide and for clipping.
  const float w = magnitude(rows[3], reach);
  result.rounding = 16 * kUnit *
                    std::max(half.x * (magnitude(rows[0], reach) + 3 * w),
                             half.y * (magnitude(rows[1], reach) + 3 * w));
  result.snapping = std::ldexp(1.0f, -view.sub_pixel_bits);
  result.drops_counter = drops_counter;
  return result;
}

DepthRange depthRange(const glm::mat4& clip_from_world) noexcept {
  const glm::dmat4 rows = glm::transpose(glm::dmat4(clip_from_world));
  const glm::dvec3 z(rows[2]);
  const glm::dvec3 w(rows[3]);
  DepthRange range;
  const double constant = glm::dot(z, w) / glm::dot(w, w);
  range.factor = rows[2].w - constant * rows[3].w;
  range.nearest = -(1 + constant) / range.factor;
  // An oblique near plane, or no perspective at all, is none of this kind.
  range.known = glm::length(z - constant * w) <= 8 * double{kUnit} * glm::length(w) &&
                range.factor < 0 && range.nearest > 0;
  return range;
}

float depthRounding(const SieveView& view, const glm::vec3& reach) noexcept {
  const glm::mat4 rows = glm::transpose(view.clip_from_world);
  return 8 * kUnit * std::max(magnitude(rows[2], reach), magnitude(rows[3], reach));
}

}  // namespace enfilade
