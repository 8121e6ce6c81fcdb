// Furniture, frames and pedestals: flat faces, few triangles.
#include <algorithm>
#include <cmath>

#include "models/noise.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;

struct MouldingPoint {
  double out, y, shade;
};

/// A square block, half as wide as `half` plus each point's `out`, moulded around; open below.
void raiseMouldedBlock(double half_x, double half_z, const std::vector<MouldingPoint>& profile,
                       double texture_size, MeshBuilder& mesh) {
  const auto at = [&](int k, const MouldingPoint& p) {
    const double x = (k == 0 || k == 3 ? -1 : 1) * (half_x + p.out);
    const double z = (k < 2 ? 1 : -1) * (half_z + p.out);
    const double along = k % 2 == 0 ? x : -z;
    (void)along;
    return Corner{{x, p.y, z}, {0, -p.y / texture_size}, p.shade};
  };
  const auto textured = [&](Corner c, int k) {
    c.texcoord.x = (k % 2 == 0 ? c.position.x : c.position.z) / texture_size;
    return c;
  };
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    for (std::size_t i = 0; i + 1 < profile.size(); ++i)
      mesh.flatQuad(textured(at(k, profile[i]), k), textured(at(next, profile[i]), k),
                    textured(at(next, profile[i + 1]), k), textured(at(k, profile[i + 1]), k));
  }
  const auto level = [&](int k) {
    Corner c = at(k, profile.back());
    c.texcoord = glm::dvec2(c.position.x, c.position.z) / texture_size;
    return c;
  };
  mesh.flatQuad(level(0), level(1), level(2), level(3));
}

Shape makePlinth(const ShapeNumbers& n) {
  const double h = n.at("height"), half = 0.5 * n.at("width"), m = std::min(0.06, 0.2 * h);
  const std::vector<MouldingPoint> profile{
      {0.6 * m, 0, 0.55},     {0.6 * m, 1.3 * m, 0.8},      {0.2 * m, 1.7 * m, 0.7},
      {0, 2 * m, 0.75},       {0, 0.5 * h, 0.95},           {0, h - 1.5 * m, 0.9},
      {0.35 * m, h - m, 0.8}, {0.7 * m, h - 0.7 * m, 0.95}, {0.7 * m, h, 1}};
  return {{}, [=](MeshBuilder& mesh) { raiseMouldedBlock(half, half, profile, 1, mesh); }};
}

Shape makeSlab(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), z = 0.5 * n.at("depth"), h = n.at("height");
  return {{}, [=](MeshBuilder& mesh) { mesh.box({-x, 0, -z}, {x, h, z}, "XxYZz", 1); }};
}

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

Shape makeBench(const ShapeNumbers& n) {
  const double x = 0.5 * n.at("width"), z = 0.5 * n.at("depth"), h = n.at("height");
  return {{}, [=](MeshBuilder& mesh) {
            const double leg = 0.06, seat = 0.09;
            for (const double sx : {-1.0, 1.0})
              for (const double sz : {-1.0, 1.0}) {
                const glm::dvec3 c(sx * (x - leg), 0, sz * (z - leg));
                mesh.box(c - glm::dvec3(0.5 * leg, 0, 0.5 * leg),
                         c + glm::dvec3(0.5 * leg, h - seat, 0.5 * leg), "XxZz", 0.6);
              }
            mesh.box({-x, h - seat, -z}, {x, h - 0.035, z}, "XxyZz", 0.6);
            mesh.setTint(glm::dvec3(0.92));
            mesh.setTransform(glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, h - 0.035, 0, 1));
            raiseMouldedBlock(
                x, z, {{0, 0, 0.8}, {0.008, 0.012, 1}, {0, 0.03, 1}, {-0.02, 0.035, 1}}, 0.6, mesh);
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

/// A row of books that fills `width`, their backs to +z, each of its own size and colour.
void raiseBooks(std::uint32_t seed, double width, double height, double depth, MeshBuilder& mesh) {
  constexpr double kColors[][3] = {{0.35, 0.08, 0.06}, {0.10, 0.16, 0.09}, {0.07, 0.10, 0.22},
                                   {0.42, 0.28, 0.10}, {0.22, 0.12, 0.06}, {0.45, 0.40, 0.30},
                                   {0.16, 0.05, 0.09}, {0.06, 0.16, 0.18}};
  double x = 0.01;
  for (std::int64_t i = 0;; ++i) {
    const double thick = 0.03 + 0.045 * hash01(seed, i, 0);
    if (x + thick > width - 0.01) break;
    const double high = height * (0.68 + 0.26 * hash01(seed, i, 1));
    const double front = depth * (0.80 + 0.12 * hash01(seed, i, 2));
    const auto& color = kColors[static_cast<std::size_t>(7.99 * hash01(seed, i, 3))];
    mesh.setTint(glm::dvec3(color[0], color[1], color[2]) * (0.8 + 0.5 * hash01(seed, i, 4)));
    if (hash01(seed, i, 5) > 0.08)
      mesh.box({x, 0, 0.03}, {x + thick - 0.002, high, front}, "XxYZ", 0.3);
    x += thick;
  }
  mesh.setTint(glm::dvec3(1));
}

Shape makeBookcase(const ShapeNumbers& n) {
  const double w = n.at("width"), h = n.at("height"), d = n.at("depth");
  const int shelves = static_cast<int>(n.at("shelves"));
  const auto seed = static_cast<std::uint32_t>(n.at("seed"));
  const bool books = n.at("books") > 0;
  return {{}, [=](MeshBuilder& mesh) {
            const double t = 0.035, x = 0.5 * w, foot = 0.12;
            const double step = (h - foot - t) / shelves;
            if (!books) {
              mesh.box({-x, 0, 0}, {-x + t, h, d}, "xXZ", 0.7);
              mesh.box({x - t, 0, 0}, {x, h, d}, "xXZ", 0.7);
              mesh.box({-x + t, 0, 0.01}, {x - t, foot, d - 0.02}, "Z", 0.7);
              mesh.setTint(glm::dvec3(0.5));
              mesh.box({-x + t, foot, 0}, {x - t, h - t, 0.012}, "Z", 0.7);
              mesh.setTint(glm::dvec3(1));
              for (int i = 0; i <= shelves; ++i) {
                const double y = foot + i * step;
                mesh.box({-x + t, y, 0.012}, {x - t, y + 0.025, d - 0.01}, "YyZ", 0.7);
              }
              mesh.box({-x - 0.02, h, 0}, {x + 0.02, h + 0.06, d + 0.03}, "xXyYZ", 0.7);
              return;
            }
            for (int i = 0; i < shelves; ++i) {
              const double y = foot + i * step + 0.025;
              mesh.setTransform(glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -x + t, y, 0, 1));
              raiseBooks(seed * 97 + static_cast<std::uint32_t>(i), w - 2 * t, step - 0.025, d,
                         mesh);
            }
            mesh.setTransform(glm::dmat4(1));
          }};
}

/// A ring of arms with candles, hung from y = 0 downward.
Shape makeChandelier(const ShapeNumbers& n) {
  const double r = n.at("radius"), drop = n.at("drop");
  const int arms = static_cast<int>(n.at("arms"));
  Shape shape;
  const auto tube = [](double thick, double share, auto center) {
    Surface s;
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
      const double out = r * v,
                   y = -drop + 0.1 - 0.22 * std::sin(3.14 * std::pow(v, 0.8)) + 0.12 * v;
      return glm::dvec3(out * c, y, out * s);
    }));
    shape.surfaces.push_back(tube(
        0.018, 0.6, [=](double v) { return glm::dvec3(r * c, -drop + 0.2 + 0.16 * v, r * s); }));
  }
  return shape;
}

}  // namespace

std::vector<ShapeKind> furnitureKinds() {
  return {
      {"plinth", 0, {{"height", 1, 0.05, 5}, {"width", 0.5, 0.05, 10}}, makePlinth},
      {"slab",
       0,
       {{"width", 1, 0.02, 100}, {"depth", 1, 0.02, 100}, {"height", 0.1, 0.01, 10}},
       makeSlab},
      {"rug",
       0,
       {{"width", 3, 0.2, 100}, {"depth", 2, 0.2, 100}, {"height", 0.012, 0.005, 1}},
       makeRug},
      {"bench",
       0,
       {{"width", 1.6, 0.3, 10}, {"depth", 0.5, 0.2, 3}, {"height", 0.46, 0.2, 2}},
       makeBench},
      {"frame",
       0,
       {{"width", 1, 0.05, 10}, {"height", 0.8, 0.05, 10}, {"border", 0.09, 0.01, 0.5}},
       makeFrame},
      {"canvas",
       0,
       {{"width", 1, 0.05, 10}, {"height", 0.8, 0.05, 10}, {"off", 0.02, 0.001, 1}},
       makeCanvas},
      {"bookcase",
       0,
       {{"width", 1.2, 0.3, 5},
        {"height", 2.3, 0.5, 5},
        {"depth", 0.32, 0.1, 1},
        {"shelves", 6, 1, 12},
        {"seed", 1, 0, 1e6},
        {"books", 0, 0, 1}},
       makeBookcase},
      {"chandelier",
       2500,
       {{"radius", 0.5, 0.1, 3}, {"drop", 0.9, 0.2, 5}, {"arms", 8, 3, 24}},
       makeChandelier},
  };
}

}  // namespace enfilade
