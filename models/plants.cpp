// Plants: trees, hedges, and palms in pots.
#include <algorithm>
#include <cmath>

#include "models/noise.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;

glm::dvec3 onSphere(double u, double v) {
  const double theta = kTau * u, phi = 0.5 * kTau * (v - 0.5);
  return {std::cos(phi) * std::cos(theta), std::sin(phi), -std::cos(phi) * std::sin(theta)};
}

/// A lumpy mass of leaves: an ellipsoid with its underside at y = 0.
Shape makeCrown(const ShapeNumbers& n) {
  const double r = n.at("radius"), h = n.at("height"), rough = n.at("rough"), point = n.at("point");
  const auto seed = static_cast<std::uint32_t>(n.at("seed"));
  CurvedSurface crown;
  crown.pole_low = crown.pole_high = true;
  crown.aspect = 1.6;
  crown.repeats = {4, 2};
  crown.at = [=](double u, double v) {
    const glm::dvec3 d = onSphere(u, v);
    const double bump = fractal3(seed, d * 3.5, 4);
    const double k = 1 + rough * bump;
    // `point` draws the upper half in, as a yew's or a poplar's.
    const double narrow = 1 - point * ramp(-0.6, 1, d.y);
    return SurfacePoint{{r * k * narrow * d.x, 0.5 * h * (1 + k * d.y), r * k * narrow * d.z},
                        std::clamp((0.6 + 0.4 * d.y * 0.7 + 0.15) + 0.7 * bump, 0.3, 1.0)};
  };
  return {{crown}, {}};
}

Shape makeTrunk(const ShapeNumbers& n) {
  const double r = n.at("radius"), h = n.at("height"), bend = n.at("bend");
  CurvedSurface trunk;
  trunk.aspect = 0.8;
  trunk.repeats = {2, h / (kTau * r) * 2};
  trunk.at = [=](double u, double v) {
    const double a = kTau * u, flare = 1 + 0.8 * std::pow(1 - v, 6) - 0.35 * v;
    const double bark = 1 + 0.08 * std::cos(5 * a + 3 * v) + 0.05 * std::cos(11 * a - 9 * v);
    return SurfacePoint{{r * flare * bark * std::cos(a) + bend * std::sin(3 * v), h * v,
                         -r * flare * bark * std::sin(a)},
                        0.75 + 0.25 * v};
  };
  return {{trunk}, {}};
}

/// Long arched leaves that spring from one point at y = 0; for a double-sided finish.
Shape makeFronds(const ShapeNumbers& n) {
  const double length = n.at("length"), wide = n.at("width");
  const int count = static_cast<int>(n.at("leaves"));
  const auto seed = static_cast<std::uint32_t>(n.at("seed"));
  Shape shape;
  for (int i = 0; i < count; ++i) {
    const double a = kTau * (i * 0.381966 + 0.03 * hash01(seed, i, 1));
    const double rise = 0.35 + 1.05 * (1 - double(i) / count) + 0.15 * hash01(seed, i, 2);
    const double l = length * (0.75 + 0.25 * hash01(seed, i, 3));
    CurvedSurface leaf;
    leaf.closed_u = false;
    leaf.aspect = 0.25;
    leaf.at = [=](double u, double v) {
      const double s = 2 * u - 1;
      const double w =
          wide * std::pow(std::sin(0.5 * kTau * std::clamp(0.03 + 0.95 * v, 0.0, 1.0)), 0.8);
      const double out = l * (0.18 * v + 0.62 * v * v) / (0.6 + 0.4 * rise);
      const double up = l * (rise * v - (0.25 + 0.5 * rise) * v * v);
      const double fold = 0.35 * w * std::abs(s) + 0.02 * l * std::sin(38 * v) * std::abs(s);
      const glm::dvec3 p(out, up + fold, s * w);
      return SurfacePoint{
          {p.x * std::cos(a) + p.z * std::sin(a), p.y, -p.x * std::sin(a) + p.z * std::cos(a)},
          0.5 + 0.5 * v};
    };
    shape.surfaces.push_back(leaf);
  }
  return shape;
}

/// A clipped hedge along x: a box with round edges and leafy faces.
Shape makeHedge(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), h = n.at("height"), z = 0.5 * n.at("depth");
  const auto seed = static_cast<std::uint32_t>(n.at("seed"));
  CurvedSurface hedge;
  hedge.pole_low = hedge.pole_high = true;
  hedge.aspect = 0.6;
  hedge.repeats = {3, x / h};
  hedge.at = [=](double u, double v) {
    // The poles lie at the two ends, where they show least.
    const glm::dvec3 sphere = onSphere(u, v), d(sphere.y, sphere.z, sphere.x);
    const double norm = std::pow(std::pow(std::abs(d.x), 14.0) + std::pow(std::abs(d.y), 14.0) +
                                     std::pow(std::abs(d.z), 14.0),
                                 1.0 / 14);
    const glm::dvec3 box = d / norm;
    const glm::dvec3 at(x * box.x, 0.5 * h * (1 + box.y), z * box.z);
    const double bump = fractal3(seed, at * 4.0, 4);
    return SurfacePoint{at + 0.08 * bump * d,
                        std::clamp(0.65 + 0.35 * box.y + 0.5 * bump, 0.3, 1.0)};
  };
  return {{hedge}, {}};
}

}  // namespace

std::vector<ShapeKind> plantKinds() {
  return {
      {"crown",
       700,
       {{"radius", 1.6, 0.05, 20},
        {"height", 3, 0.05, 40},
        {"rough", 0.5, 0, 1},
        {"point", 0, 0, 0.98},
        {"seed", 1, 0, 1e6}},
       makeCrown},
      {"trunk",
       150,
       {{"radius", 0.15, 0.01, 3}, {"height", 2, 0.05, 40}, {"bend", 0, -2, 2}},
       makeTrunk},
      {"fronds",
       1500,
       {{"length", 1.3, 0.1, 10},
        {"width", 0.12, 0.01, 2},
        {"leaves", 14, 3, 40},
        {"seed", 1, 0, 1e6}},
       makeFronds},
      {"hedge",
       700,
       {{"width", 4, 0.2, 100},
        {"height", 1, 0.1, 10},
        {"depth", 0.7, 0.1, 20},
        {"seed", 1, 0, 1e6}},
       makeHedge},
  };
}

}  // namespace enfilade
