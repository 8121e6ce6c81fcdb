// Walls, painted once from the cornice (v = 0) to the skirting (v = 1); they repeat along u only.
#include <algorithm>
#include <cmath>

#include "models/noise.h"
#include "models/patterns.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kDado = 0.74;  // below lies the dado

/// The light that reaches a wall: less near the ceiling and the floor.
double wallLight(double v) {
  return (0.80 + 0.20 * ramp(0, 0.22, v)) * (0.80 + 0.20 * ramp(0, 0.16, 1 - v));
}

/// A line of moulding at height `at`: light above, shadow below.
double mouldingAt(double at, double half, double v) {
  const double x = (v - at) / half;
  if (std::abs(x) > 1.6) return 1;
  if (x > 1) return 0.80 + 0.33 * (x - 1);
  return x < -0.4 ? 1.10 : (x < 0.4 ? 1.0 : 0.88);
}

glm::dvec3 mottled(const glm::dvec3& color, std::uint32_t seed, const glm::dvec2& uv,
                   double amount) {
  return color * (1 + amount * fractal2(seed, uv * glm::dvec2(6, 12), 4, 6));
}

/// Panels of the dado: a raised field in each.
double panelShade(const glm::dvec2& uv, double top, double bottom, int count) {
  const double x = uv.x * count - std::floor(uv.x * count), y = (uv.y - top) / (bottom - top);
  const double tall = (bottom - top) * 2.0 * count;  // panel's height over its width, about
  const double dx = std::min(x, 1 - x), dy = std::min(y, 1 - y) * tall;
  const double edge = std::min(dx, dy);
  if (edge < 0.10) return 1;
  const bool lit_side = (dy < dx) ? y > 0.5 : x > 0.5;
  return edge < 0.135 ? (lit_side ? 1.10 : 0.84) : 0.97;
}

glm::dvec3 dado(const PlanFinish& f, const glm::dvec2& uv) {
  const double moulding = mouldingAt(kDado, 0.008, uv.y);
  return mottled(colorOf(f, 1), f.seed + 7, uv, 0.03) * moulding *
         panelShade(uv, kDado + 0.02, 0.96, 2);
}

glm::dvec3 framed(const PlanFinish& f, const glm::dvec2& uv, const glm::dvec3& field) {
  const glm::dvec3 color = uv.y > kDado - 0.008 ? dado(f, uv)
                                                : field * mouldingAt(0.115, 0.005, uv.y) *
                                                      mouldingAt(kDado, 0.008, uv.y);
  return color * wallLight(uv.y);
}

glm::dvec3 painted(const PlanFinish& f, const glm::dvec2& uv) {
  return framed(f, uv, mottled(colorOf(f, 0), f.seed, uv, 0.06));
}

glm::dvec3 stripes(const PlanFinish& f, const glm::dvec2& uv) {
  const double x = uv.x * 8 - std::floor(uv.x * 8);
  const double wide = ramp(0.0, 0.02, x) * (1 - ramp(0.5, 0.52, x));
  const double thin = ramp(0.72, 0.735, x) * (1 - ramp(0.775, 0.79, x));
  return framed(f, uv, glm::mix(colorOf(f, 0), colorOf(f, 2), std::max(0.55 * wide, 0.9 * thin)));
}

/// Damask: an ogee of leaves, mirrored left and right, in rows that are offset by half.
glm::dvec3 damask(const PlanFinish& f, const glm::dvec2& uv) {
  glm::dvec2 p = uv * glm::dvec2(3, 8);
  const double row = std::floor(p.y);
  p.x += 0.5 * (row - 2 * std::floor(row / 2));
  const double x = std::abs(p.x - std::floor(p.x) - 0.5) * 2, y = p.y - row;
  const double ogee = std::abs(x - (0.5 + 0.42 * std::sin(kTau * (y - 0.25)) * 0.9));
  const double angle = std::atan2(y - 0.5, x), r = std::hypot(x, 1.35 * (y - 0.5));
  const double flower = r - 0.25 * (1 + 0.35 * std::cos(6 * angle));
  const double leaf = std::abs(std::hypot(x - 0.38, 1.2 * (y - 0.5)) - 0.16);
  const double figure = std::max(
      {1 - ramp(0.03, 0.07, ogee), 1 - ramp(0, 0.04, flower), 0.8 * (1 - ramp(0.02, 0.06, leaf))});
  return framed(f, uv, glm::mix(colorOf(f, 0), colorOf(f, 2), 0.75 * figure));
}

/// Glazed tiles with blue figures up to the dado's top, plaster above.
glm::dvec3 tiles(const PlanFinish& f, const glm::dvec2& uv) {
  const glm::dvec2 p = uv * glm::dvec2(10, 20);
  const glm::dvec2 cell = glm::floor(p), in = p - cell;
  if (uv.y < 0.45) {
    const double band = uv.y > 0.42 ? 0.5 + 0.5 * std::cos(kTau * 20 * uv.x) : 0;
    return glm::mix(mottled(colorOf(f, 0), f.seed, uv, 0.04), colorOf(f, 2), 0.7 * band) *
           wallLight(uv.y);
  }
  const auto i = static_cast<std::int64_t>(cell.x), j = static_cast<std::int64_t>(cell.y);
  const glm::dvec2 c = in - 0.5;
  const double angle = std::atan2(c.y, c.x), r = glm::length(c);
  const double petals = 2 + std::floor(4 * hash01(f.seed, i, j));
  const double flower =
      r - 0.2 * (1 + 0.5 * std::cos(petals * angle + 6 * hash01(f.seed + 1, i, j)));
  const double corner = glm::length(glm::abs(c) - 0.5);
  const double figure =
      std::max({0.85 * (1 - ramp(0, 0.04, flower)) * ramp(0.02, 0.08, r),
                1 - ramp(0.10, 0.13, corner), 0.6 * (1 - ramp(0.008, 0.02, std::abs(r - 0.40)))});
  const double edge = std::min({in.x, 1 - in.x, in.y, 1 - in.y});
  const double tint = 0.05 * (hash01(f.seed + 2, i, j) - 0.5);
  const glm::dvec3 tile = glm::mix(colorOf(f, 1) * (1 + tint), colorOf(f, 2), figure);
  return tile * (0.78 + 0.22 * ramp(0.01, 0.03, edge)) * wallLight(uv.y);
}

/// Slabs of veined stone between pilasters.
glm::dvec3 stone(const PlanFinish& f, const glm::dvec2& uv) {
  const double x = uv.x * 2 - std::floor(uv.x * 2);
  const double pilaster = std::min(x, 1 - x);
  const glm::dvec2 p = uv * glm::dvec2(4, 8);
  const double warp = fractal2(f.seed + 3, p, 4, 4);
  const double line = std::abs(fractal2(f.seed, p + glm::dvec2(1.3 * warp, warp), 4, 4));
  const double vein = 1 - ramp(0, 0.06, line);
  if (pilaster < 0.09 || uv.y < 0.12 || uv.y > 0.93) {
    const double groove = std::min(std::abs(pilaster - 0.09), 1.0);
    return mottled(colorOf(f, 1), f.seed, uv, 0.05) * (0.82 + 0.18 * ramp(0, 0.012, groove)) *
           mouldingAt(0.12, 0.006, uv.y) * mouldingAt(0.93, 0.006, uv.y) * wallLight(uv.y);
  }
  const glm::dvec3 slab = glm::mix(colorOf(f, 0) * (1 + 0.15 * warp), colorOf(f, 2), 0.5 * vein);
  const double edge = pilaster - 0.09;
  return slab * (0.75 + 0.25 * ramp(0, 0.015, edge)) * wallLight(uv.y);
}

}  // namespace

std::vector<PatternKind> wallPatterns() {
  return {
      {"wall-painted", 256, 512, painted}, {"wall-stripes", 512, 512, stripes},
      {"wall-damask", 512, 1024, damask},  {"wall-tiles", 512, 1024, tiles},
      {"wall-stone", 512, 512, stone},
  };
}

}  // namespace enfilade
