// What hangs on walls and from ceilings, or lies on floors: frames, pictures, lights, rugs.
#include <algorithm>
#include <cmath>

#include "models/moulded_block.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;

/// A block with a bevelled top that shows its picture once: a rug, a table's top.
Shape makeRug(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), z = 0.5 * n.at("depth"), h = n.at("height");
  return {{}, [=](MeshBuilder& mesh) {
            const auto at = [&](double sx, double sz, double y) {
              return Corner{{sx * x, y, sz * z}, {0.5 + 0.5 * sx, 0.5 + 0.5 * sz}, 1};
            };
            mesh.flatQuad(at(-1, 1, h), at(1, 1, h), at(1, -1, h), at(-1, -1, h));
            const double corners[4][2] = {{-1, 1}, {1, 1}, {1, -1}, {-1, -1}};
            for (int k = 0; k < 4; ++k) {
              const auto& a = corners[k];
              const auto& b = corners[(k + 1) % 4];
              mesh.flatQuad(at(a[0], a[1], 0), at(b[0], b[1], 0), at(b[0], b[1], h),
                            at(a[0], a[1], h));
            }
          }};
}

/// A picture's frame around an opening of `width` × `height`, its middle at the origin, its back on
/// z = 0.
Shape makeFrame(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), y = 0.5 * n.at("height"), w = n.at("border");
  return {{}, [=](MeshBuilder& mesh) {
            const MouldingPoint profile[] = {{w, 0, 0.7},
                                             {w, 0.35 * w, 0.9},
                                             {0.85 * w, 0.5 * w, 1},
                                             {0.6 * w, 0.52 * w, 0.95},
                                             {0.4 * w, 0.3 * w, 0.7},
                                             {0.15 * w, 0.34 * w, 0.95},
                                             {0, 0.2 * w, 0.75}};  // out, depth, shade
            const auto at = [&](int k, const MouldingPoint& p) {
              const double sx = k == 0 || k == 3 ? -1 : 1, sy = k < 2 ? -1 : 1;
              return Corner{{sx * (x + p.out), sy * (y + p.out), p.y},
                            {4 * (k % 2 == 0 ? sx * x : sy * y), 4 * p.out},
                            p.shade};
            };
            for (int k = 0; k < 4; ++k)
              for (std::size_t i = 0; i + 1 < std::size(profile); ++i)
                mesh.flatQuad(at(k, profile[i]), at((k + 1) % 4, profile[i]),
                              at((k + 1) % 4, profile[i + 1]), at(k, profile[i + 1]));
          }};
}

/// A flat picture that looks to +z, its middle at the origin, `off` the wall.
Shape makeCanvas(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), y = 0.5 * n.at("height"), z = n.at("off");
  return {{}, [=](MeshBuilder& mesh) {
            mesh.flatQuad({{-x, -y, z}, {0, 1}, 1}, {{x, -y, z}, {1, 1}, 1}, {{x, y, z}, {1, 0}, 1},
                          {{-x, y, z}, {0, 0}, 1});
          }};
}

/// A ring of arms with candles, hung from y = 0 downward.
Shape makeChandelier(const ShapeNumbers& n) {
  const double r = n.at("radius"), drop = n.at("drop");
  const int arms = static_cast<int>(n.at("arms"));
  Shape shape;
  const auto tube = [](double thick, double share, auto center) {
    CurvedSurface s;
    s.aspect = 0.5;
    s.share = share;
    s.pole_low = s.pole_high = true;
    s.at = [=](double u, double v) {
      const glm::dvec3 c = center(v), t = glm::normalize(center(v + 1e-3) - center(v - 1e-3));
      const glm::dvec3 side = glm::normalize(glm::cross(t, glm::dvec3(0.31, 0.17, 0.93)));
      const glm::dvec3 out = glm::cross(side, t);
      const double fat = thick * std::min(1.0, 12 * std::min(v, 1 - v));
      return SurfacePoint{c + fat * (std::cos(kTau * u) * out + std::sin(kTau * u) * side), 0.9};
    };
    return s;
  };
  shape.surfaces.push_back(tube(0.02, 2, [=](double v) { return glm::dvec3(0, -drop * v, 0); }));
  for (int i = 0; i < arms; ++i) {
    const double a = kTau * i / arms, c = std::cos(a), s = std::sin(a);
    shape.surfaces.push_back(tube(0.012, 1, [=](double v) {
      const double out = r * v, y = -drop + 0.1 -
                                    0.22 * std::sin(3.14 * std::pow(std::max(v, 0.0), 0.8)) +
                                    0.12 * v;
      return glm::dvec3(out * c, y, out * s);
    }));
    shape.surfaces.push_back(tube(
        0.018, 0.6, [=](double v) { return glm::dvec3(r * c, -drop + 0.2 + 0.16 * v, r * s); }));
  }
  return shape;
}

}  // namespace

std::vector<ShapeKind> hangingKinds() {
  return {
      {"rug",
       0,
       {{"width", 3, 0.2, 100}, {"depth", 2, 0.2, 100}, {"height", 0.012, 0.005, 1}},
       makeRug},
      {"frame",
       0,
       {{"width", 1, 0.05, 10}, {"height", 0.8, 0.05, 10}, {"border", 0.09, 0.01, 0.5}},
       makeFrame},
      {"canvas",
       0,
       {{"width", 1, 0.05, 10}, {"height", 0.8, 0.05, 10}, {"off", 0.02, 0.001, 1}},
       makeCanvas},
      {"chandelier",
       2500,
       {{"radius", 0.5, 0.1, 3}, {"drop", 0.9, 0.2, 5}, {"arms", 8, 3, 24}},
       makeChandelier},
  };
}

}  // namespace enfilade
