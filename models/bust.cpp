// A portrait bust, carved out of a turned block by bumps and hollows.
#include <algorithm>
#include <cmath>
#include <memory>

#include "models/noise.h"
#include "models/profile_curve.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;

/// A smooth bump around a direction: `angle` from the face's front, height `y` (unit bust).
struct Bump {
  double angle, y, wide, high, out;
};

/// Features of a face, for a bust of height 1; both sides of those beside the middle.
constexpr Bump kFeatures[] = {
    {0, 0.735, 0.12, 0.032, 0.046},      // nose
    {0, 0.712, 0.15, 0.013, 0.024},      // its tip
    {0, 0.780, 0.10, 0.03, 0.018},       // its bridge
    {0, 0.660, 0.24, 0.011, 0.019},      // upper lip
    {0, 0.638, 0.20, 0.010, 0.018},      // lower lip
    {0, 0.590, 0.32, 0.025, 0.030},      // chin
    {0.36, 0.783, 0.17, 0.018, -0.032},  // eye sockets
    {0.36, 0.781, 0.11, 0.011, 0.021},   // eyes
    {0.34, 0.820, 0.26, 0.012, 0.017},   // brows
    {0.58, 0.715, 0.28, 0.04, 0.016},    // cheeks
    {0.95, 0.640, 0.35, 0.035, 0.018},   // jaw
    {1.55, 0.745, 0.16, 0.035, 0.028},   // ears
    {1.50, 0.745, 0.07, 0.02, -0.016},   // their hollows
};

double featuresAt(double angle, double y) {
  double out = 0;
  for (const Bump& b : kFeatures) {
    for (const double sign : {1.0, -1.0}) {
      if (sign < 0 && b.angle == 0) continue;
      const double a = std::remainder(angle - sign * b.angle, kTau) / b.wide;
      const double h = (y - b.y) / b.high;
      out += b.out * std::exp(-0.5 * (a * a + h * h));
    }
  }
  return out;
}

/// Curls over the crown and the back of the head, 0 on the face.
double hairAt(std::uint32_t seed, double curls, double angle, double y) {
  const double hairline =
      0.84 - 0.12 * ramp(0.7, 1.5, std::abs(angle)) - 0.14 * ramp(1.5, 2.4, std::abs(angle));
  const double where = ramp(hairline - 0.01, hairline + 0.02, y) * (1 - ramp(0.955, 1.0, y));
  const glm::dvec3 p(std::cos(angle), 7 * y, std::sin(angle));
  const double warp = 0.8 * fractal3(seed, p * 2.0, 3);
  return where * (0.022 + 0.014 * std::sin(curls * (angle + 3.1 * y) + 6 * warp));
}

Shape makeBust(const ShapeNumbers& n) {
  const double size = n.at("height"), curls = std::round(n.at("curls")), girth = n.at("girth");
  const auto seed = static_cast<std::uint32_t>(n.at("seed"));
  // Half width by height: socle, chest, neck, jaw, temples, crown.
  const auto curve = std::make_shared<ProfileCurve>(std::vector<glm::dvec2>{
      {0.14, 0},      {0.14, 0},     {0.14, 0.03},   {0.10, 0.05},  {0.085, 0.10},
      {0.11, 0.14},   {0.20, 0.19},  {0.285, 0.29},  {0.285, 0.37}, {0.20, 0.435},
      {0.105, 0.475}, {0.088, 0.53}, {0.095, 0.575}, {0.118, 0.62}, {0.137, 0.70},
      {0.147, 0.79},  {0.146, 0.87}, {0.115, 0.95},  {0.06, 0.99},  {0, 1.0}});
  CurvedSurface surface;
  surface.pole_high = true;
  surface.aspect = 0.9;
  surface.repeats = {2, 2};
  surface.at = [=](double u, double v) {
    // u = 0 lies at the back; the face looks to +z.
    const double angle = kTau * (u - 0.5);
    const glm::dvec2 p = curve->at(v);
    const double head = ramp(0.5, 0.62, p.y),
                 chest = ramp(0.12, 0.2, p.y) * (1 - ramp(0.42, 0.5, p.y));
    const double hair = hairAt(seed, curls, angle, p.y);
    const double features = head * featuresAt(angle, p.y);
    const double folds =
        0.012 * chest *
        std::sin(9 * angle + 30 * p.y +
                 4 * fractal3(seed, {std::cos(angle), 5 * p.y, std::sin(angle)}, 3));
    const double r = p.x * girth + hair + features + folds;
    const double deep = glm::mix(1.0, 1.22, head) * glm::mix(1.0, 0.62, chest);
    const double forward = 0.03 * head - 0.02 * ramp(0.9, 1, p.y);
    const double shade =
        0.84 + 9 * std::min(features, 0.015) + 6 * (hair > 0 ? hair - 0.022 : 0.0) + 6 * folds;
    return SurfacePoint{
        size * glm::dvec3(r * std::sin(angle), p.y, r * deep * std::cos(angle) + forward),
        std::clamp(shade, 0.4, 1.0) * (0.75 + 0.25 * ramp(0, 0.3, p.y))};
  };
  return {{surface}, {}};
}

}  // namespace

std::vector<ShapeKind> bustKinds() {
  return {{"bust",
           8000,
           {{"height", 0.75, 0.05, 5},
            {"girth", 1, 0.7, 1.4},
            {"curls", 16, 0, 60},
            {"seed", 1, 0, 1e6}},
           makeBust}};
}

}  // namespace enfilade
