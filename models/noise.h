#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace enfilade {

/// Reproducible randomness: integers hashed, the same on every machine.

/// Well-mixed bits of `x`.
std::uint32_t hashBits(std::uint32_t x);
/// 0…1, from integers.
double hash01(std::uint32_t seed, std::int64_t x, std::int64_t y = 0, std::int64_t z = 0);

/// Smooth value noise, −1…1, one feature a unit.  With `period` > 0 it repeats after that many
/// units in x and y.
double noise2(std::uint32_t seed, const glm::dvec2& p, int period = 0);
double noise3(std::uint32_t seed, const glm::dvec3& p);

/// Octaves of noise, each of half the size and half the strength; −1…1.
double fractal2(std::uint32_t seed, const glm::dvec2& p, int octaves, int period = 0);
double fractal3(std::uint32_t seed, const glm::dvec3& p, int octaves);

/// 0 up to `a`, 1 from `b` on, smooth between.
double ramp(double a, double b, double x);

}  // namespace enfilade
