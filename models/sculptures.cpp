// Sculptures: surfaces carved by formula.
#include <algorithm>
#include <cmath>

#include "models/noise.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kPi = kTau / 2;

/// The unit sphere, v from the south pole to the north.
glm::dvec3 onSphere(double u, double v) {
  const double theta = kTau * u, phi = kPi * (v - 0.5);
  return {std::cos(phi) * std::cos(theta), std::sin(phi), -std::cos(phi) * std::sin(theta)};
}

/// What is left of a ball in some direction: its share of the radius, and how much sky reaches it.
struct Carved {
  double radius, shade;
};

/// A ball carved by direction, stood with its lowest point a hair below y = 0.
Shape carvedBall(double r, const std::function<Carved(const glm::dvec3&)>& carve) {
  double lowest = 0;
  for (int j = 0; j <= 24; ++j) {
    for (int i = 0; i < 48; ++i) {
      const glm::dvec3 d = onSphere(i / 48.0, j / 48.0);
      lowest = std::min(lowest, d.y * carve(d).radius);
    }
  }
  CurvedSurface surface;
  surface.pole_low = surface.pole_high = true;
  surface.aspect = 1.8;
  surface.repeats = {2, 1};
  surface.at = [=](double u, double v) {
    const glm::dvec3 d = onSphere(u, v);
    const Carved left = carve(d);
    return SurfacePoint{r * (left.radius * d - glm::dvec3(0, 0.99 * lowest, 0)),
                        left.shade * (0.65 + 0.35 * ramp(-1, 0, d.y))};
  };
  return {{surface}, {}};
}

double powered(double x, double exponent) {
  return std::copysign(std::pow(std::abs(x), exponent), x);
}

/// Source: Barr, Superquadrics and Angle-Preserving Transformations, 1981.
Shape makeSuperquadric(const ShapeNumbers& n) {
  const double r = n.at("radius"), east = n.at("east"), north = n.at("north"),
               twist = n.at("twist"), tall = n.at("tall");
  CurvedSurface surface;
  surface.pole_low = surface.pole_high = true;
  surface.aspect = 1.6;
  surface.repeats = {2, 1};
  surface.at = [=](double u, double v) {
    const double phi = kPi * (v - 0.5), theta = kTau * u;
    const double y = powered(std::sin(phi), north);
    const double ring = std::pow(std::max(std::cos(phi), 0.0), north);
    const double x = ring * powered(std::cos(theta), east),
                 z = -ring * powered(std::sin(theta), east);
    const double a = twist * y, c = std::cos(a), s = std::sin(a);
    return SurfacePoint{{r * (c * x + s * z), r * tall * (y + 1), r * (c * z - s * x)},
                        0.65 + 0.35 * ramp(-1, 0.2, y)};
  };
  return {{surface}, {}};
}

Shape makePebble(const ShapeNumbers& n) {
  const double r = n.at("radius"), rough = n.at("rough"), scale = n.at("scale");
  const auto seed = static_cast<std::uint32_t>(n.at("seed"));
  return carvedBall(r, [=](const glm::dvec3& d) {
    const double bump = fractal3(seed, d * scale, 5);
    const double ridge = 1 - std::abs(noise3(seed + 77, d * (0.7 * scale)));
    return Carved{1 + rough * (0.8 * bump + 0.4 * (ridge - 0.7)),
                  std::clamp(0.8 + 0.5 * bump, 0.4, 1.0)};
  });
}

/// A ball pierced, as it were, by the gyroid: ribbons stand out of it.
Shape makeGyroidBall(const ShapeNumbers& n) {
  const double r = n.at("radius"), scale = n.at("scale"), depth = n.at("depth");
  return carvedBall(r, [=](const glm::dvec3& d) {
    const glm::dvec3 p = d * scale;
    const double g = std::sin(p.x) * std::cos(p.y) + std::sin(p.y) * std::cos(p.z) +
                     std::sin(p.z) * std::cos(p.x);
    const double high = ramp(-0.35, 0.35, g);
    return Carved{1 - depth * (1 - high), 0.45 + 0.55 * high};
  });
}

/// A tube of radius `thick` around the torus knot (p, q), ribbed along its way.
Shape makeKnot(const ShapeNumbers& n) {
  const double r = n.at("radius"), thick = n.at("thick"), p = std::round(n.at("p")),
               q = std::round(n.at("q")), ribs = std::round(n.at("ribs"));
  const auto center = [=](double t) {
    const double ring = 0.68 + 0.32 * std::cos(q * kTau * t);
    return r * glm::dvec3(ring * std::cos(p * kTau * t), 0.36 * std::sin(q * kTau * t),
                          ring * std::sin(p * kTau * t));
  };
  CurvedSurface tube;
  tube.closed_v = true;
  tube.aspect = 0.18;
  tube.repeats = {1, 8};
  tube.at = [=](double u, double v) {
    const glm::dvec3 c = center(v), tangent = glm::normalize(center(v + 1e-4) - center(v - 1e-4));
    const glm::dvec3 side = glm::normalize(glm::cross(tangent, c));
    const glm::dvec3 out = glm::cross(side, tangent);
    const double rib = 1 + 0.12 * std::cos(ribs * kTau * v + 3 * kTau * u);
    const double angle = kTau * u;
    const glm::dvec3 around = std::cos(angle) * out + std::sin(angle) * side;
    const glm::dvec3 local = c + around * (thick * r * rib);
    // Stood on edge: the knot's own axis looks to +z.
    const glm::dvec3 stood(local.x, r * (1 + 1.13 * thick) - local.z, local.y);
    return SurfacePoint{stood, std::clamp(0.55 + 3.2 * (rib - 0.9), 0.45, 1.0)};
  };
  return {{tube}, {}};
}

/// An ammonite on edge: a ribbed tube that winds outward in a plane and grows as it goes.
Shape makeAmmonite(const ShapeNumbers& n) {
  const double h = n.at("height"), turns = n.at("turns"), ribs = n.at("ribs");
  const double grow = std::log(n.at("growth"));
  // Sizes at the mouth, for an ammonite that is `h` high; the mouth lies a little above the middle.
  const double mouth_angle = 0.35, down = kTau * 0.25 + mouth_angle;
  const double bottom = std::exp(-grow * down / kTau), top = std::exp(-grow * (1 - 0.25 + 0.0557));
  const double tube = 0.42, size = h / ((1 + tube) * (bottom + top));
  CurvedSurface shell;
  shell.pole_low = shell.pole_high = true;
  shell.aspect = 0.12;
  shell.repeats = {1, 12};
  shell.at = [=](double u, double v) {
    const double back = turns * (1 - std::pow(v, 0.7)), scale = size * std::exp(-grow * back);
    const double angle = mouth_angle - kTau * back;
    const double rib = std::cos(ribs * angle), cap = std::clamp((v - 0.985) / 0.015, 0.0, 1.0);
    const double thick =
        tube * scale * (1 + 0.07 * rib) * std::sqrt(1 - cap * cap) * std::min(1.0, 60 * v);
    const double out = scale + thick * std::cos(kTau * u);
    return SurfacePoint{{out * std::cos(angle), size * (1 + tube) * bottom + out * std::sin(angle),
                         -0.85 * thick * std::sin(kTau * u)},
                        std::clamp(0.78 + 0.2 * rib + 0.15 * std::cos(kTau * u), 0.4, 1.0)};
  };
  return {{shell}, {}};
}

}  // namespace

std::vector<ShapeKind> sculptureKinds() {
  return {
      {"superquadric",
       3000,
       {{"radius", 0.35, 0.02, 5},
        {"east", 0.5, 0.1, 4},
        {"north", 0.5, 0.1, 4},
        {"twist", 0, -6, 6},
        {"tall", 1, 0.2, 4}},
       makeSuperquadric},
      {"pebble",
       4000,
       {{"radius", 0.35, 0.02, 5},
        {"rough", 0.25, 0, 1},
        {"scale", 2.2, 0.2, 20},
        {"seed", 1, 0, 1e6}},
       makePebble},
      {"gyroid-ball",
       6000,
       {{"radius", 0.4, 0.02, 5}, {"scale", 6, 1, 30}, {"depth", 0.3, 0, 0.8}},
       makeGyroidBall},
      {"knot",
       6000,
       {{"radius", 0.4, 0.02, 5},
        {"thick", 0.16, 0.02, 0.5},
        {"p", 2, 1, 9},
        {"q", 3, 1, 9},
        {"ribs", 36, 0, 400}},
       makeKnot},
      {"ammonite",
       5000,
       {{"height", 0.8, 0.05, 5}, {"turns", 4, 1, 9}, {"ribs", 22, 0, 80}, {"growth", 2, 1.2, 5}},
       makeAmmonite},
  };
}

}  // namespace enfilade
