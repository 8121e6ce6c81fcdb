#include "models/noise.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

std::int64_t wrapped(std::int64_t i, int period) {
  return period > 0 ? ((i % period) + period) % period : i;
}

}  // namespace

std::uint32_t hashBits(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

double hash01(std::uint32_t seed, std::int64_t x, std::int64_t y, std::int64_t z) {
  const std::uint32_t mixed = seed * 0x9e3779b1u + static_cast<std::uint32_t>(x) * 0x85ebca77u +
                              static_cast<std::uint32_t>(y) * 0xc2b2ae3du +
                              static_cast<std::uint32_t>(z) * 0x27d4eb2fu;
  return hashBits(hashBits(mixed) + mixed) / 4294967295.0;
}

double noise2(std::uint32_t seed, const glm::dvec2& p, int period) {
  const auto x = static_cast<std::int64_t>(std::floor(p.x)),
             y = static_cast<std::int64_t>(std::floor(p.y));
  const auto at = [&](std::int64_t i, std::int64_t j) {
    return 2 * hash01(seed, wrapped(x + i, period), wrapped(y + j, period)) - 1;
  };
  const double u = fade(p.x - static_cast<double>(x)), v = fade(p.y - static_cast<double>(y));
  return glm::mix(glm::mix(at(0, 0), at(1, 0), u), glm::mix(at(0, 1), at(1, 1), u), v);
}

double noise3(std::uint32_t seed, const glm::dvec3& p) {
  const glm::dvec3 f = glm::floor(p);
  const auto x = static_cast<std::int64_t>(f.x), y = static_cast<std::int64_t>(f.y),
             z = static_cast<std::int64_t>(f.z);
  const auto at = [&](std::int64_t i, std::int64_t j, std::int64_t k) {
    return 2 * hash01(seed, x + i, y + j, z + k) - 1;
  };
  const double u = fade(p.x - f.x), v = fade(p.y - f.y), w = fade(p.z - f.z);
  const double low =
      glm::mix(glm::mix(at(0, 0, 0), at(1, 0, 0), u), glm::mix(at(0, 1, 0), at(1, 1, 0), u), v);
  const double high =
      glm::mix(glm::mix(at(0, 0, 1), at(1, 0, 1), u), glm::mix(at(0, 1, 1), at(1, 1, 1), u), v);
  return glm::mix(low, high, w);
}

double fractal2(std::uint32_t seed, const glm::dvec2& p, int octaves, int period) {
  double sum = 0, strength = 0.5;
  int scale = 1;
  for (int i = 0; i < octaves; ++i, scale *= 2, strength *= 0.5)
    sum +=
        strength * noise2(seed + static_cast<std::uint32_t>(i), p * double(scale), period * scale);
  return sum;
}

double fractal3(std::uint32_t seed, const glm::dvec3& p, int octaves) {
  double sum = 0, strength = 0.5, scale = 1;
  for (int i = 0; i < octaves; ++i, scale *= 2, strength *= 0.5)
    sum += strength * noise3(seed + static_cast<std::uint32_t>(i), p * scale);
  return sum;
}

double ramp(double a, double b, double x) {
  const double t = std::clamp((x - a) / (b - a), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace enfilade
