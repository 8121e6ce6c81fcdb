#include "models/noise.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

double fade(double t) { return t * t * t * (t * (t * 6 - 15) + 10); }

/// The lattice point below `x`, and how far beyond it `x` lies.
struct Lattice {
  explicit Lattice(double x) : low(static_cast<std::int32_t>(x)) {
    low -= low > x;
    part = x - low;
  }
  std::int32_t low;
  double part;
};

/// The lattice points to both sides, repeating after `period` if that is not 0.
struct LatticePair {
  LatticePair(std::int32_t i, std::int32_t period) : low(i), high(i + 1) {
    if (period <= 0) return;
    low = i % period;
    low += low < 0 ? period : 0;
    high = low + 1 == period ? 0 : low + 1;
  }
  std::int32_t low, high;
};

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
  return hashBits(mixed) * (1.0 / 4294967295.0);
}

double noise2(std::uint32_t seed, const glm::dvec2& p, int period) {
  const Lattice in_x(p.x), in_y(p.y);
  const LatticePair x(in_x.low, period), y(in_y.low, period);
  const double u = fade(in_x.part), v = fade(in_y.part);
  const double low = glm::mix(hash01(seed, x.low, y.low), hash01(seed, x.high, y.low), u);
  const double high = glm::mix(hash01(seed, x.low, y.high), hash01(seed, x.high, y.high), u);
  return 2 * glm::mix(low, high, v) - 1;
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
