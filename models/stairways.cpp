// Stairs and balustrades.
#include <cmath>
#include <memory>

#include "models/profile_curve.h"
#include "models/shapes.h"

namespace enfilade {
namespace {

constexpr double kTau = 6.283185307179586;
constexpr double kNosing = 0.025;     // of a tread beyond its riser [m]
constexpr double kTread = 0.035;      // its thickness [m]
constexpr double kBaluster = 0.028;   // radius of a baluster where it is thickest [m]
constexpr double kRail = 0.032;       // half the width and height of a handrail [m]
constexpr double kRailPiece = 0.4;    // length of a piece of it [m]
constexpr double kPost = 0.055;       // half the width of a newel post [m]
constexpr double kPostHigher = 0.14;  // than the handrail [m]

/// Radius and height, both shares, from the foot up: foot, vase, neck, head.
const std::vector<glm::dvec2> kBalusterProfile{{0.8, 0},    {0.8, 0.04},  {0.5, 0.07},  {0.9, 0.2},
                                               {1, 0.27},   {0.75, 0.42}, {0.42, 0.62}, {0.36, 0.8},
                                               {0.6, 0.86}, {0.36, 0.92}, {0.6, 1}};

/// Both sides of a flight: `outline` holds (z, y) counter-clockwise as seen from +x, and may be
/// fanned out from its first.
void raiseSides(double half, const std::vector<glm::dvec2>& outline, MeshBuilder& mesh) {
  const auto corner = [&](double x, const glm::dvec2& p) {
    return Corner{{x, p.y, p.x}, {p.x, -p.y}, 1};
  };
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const glm::dvec2 &a = outline[0], &b = outline[i - 1], &c = outline[i];
    mesh.flatTriangle(corner(half, a), corner(half, b), corner(half, c));
    mesh.flatTriangle(corner(-half, a), corner(-half, c), corner(-half, b));
  }
}

/// A step of a flight, `i` steps up.  Where its sides meet those of the steps before and behind it
/// and the edges of its tread they have the same corners: no light shows through a joint.
void raiseStep(int i, double half, double rise, double tread, MeshBuilder& mesh) {
  const double top = (i + 1) * rise, under = top - kTread, front = -i * tread, back = front - tread;
  mesh.box({-half, top - rise, back}, {half, under, front}, "Z");
  mesh.box({-half, under, back}, {half, top, front + kNosing}, "YZ");
  mesh.box({-half, under, front}, {half, top, front + kNosing}, "y");
  raiseSides(half,
             {{back, top},
              {front + kNosing, top},
              {front + kNosing, under},
              {front, under},
              {back, under}},
             mesh);
  std::vector<glm::dvec2> below{{back, 0}, {back, under}, {front, under}};
  if (i > 0) below.insert(below.end(), {{front, top - rise}, {front, under - rise}});
  below.emplace_back(front, 0);
  raiseSides(half, below, mesh);
}

/// A flight that rises toward −z from z = 0, solid below.  The last riser is the edge of the floor
/// that it leads to, which is not its own.
Shape makeStairs(const ShapeNumbers& n) {
  const double half = 0.5 * n.at("width");
  const int risers = static_cast<int>(std::lround(n.at("steps")));
  const double rise = n.at("height") / risers, tread = n.at("run") / (risers - 1);
  return {{}, [=](MeshBuilder& mesh) {
            for (int i = 0; i + 1 < risers; ++i) raiseStep(i, half, rise, tread, mesh);
            const double end = -(risers - 1) * tread;
            mesh.box({-half, 0, end}, {half, (risers - 1) * rise - kTread, end}, "z");
          }};
}

/// One baluster from `foot`, `height` high.
CurvedSurface balusterAt(const glm::dvec3& foot, double height,
                         const std::shared_ptr<const ProfileCurve>& profile) {
  CurvedSurface surface;
  surface.aspect = 0.35;
  surface.at = [=](double u, double v) {
    const glm::dvec2 p = profile->at(v);
    const double angle = kTau * u;
    return SurfacePoint{foot + glm::dvec3(p.x * kBaluster * std::cos(angle), p.y * height,
                                          -p.x * kBaluster * std::sin(angle)),
                        1};
  };
  return surface;
}

/// A bar along +x from `from` to `to`, whose ends are upright, in pieces that carry light.
void raiseRail(const glm::dvec3& from, const glm::dvec3& to, MeshBuilder& mesh) {
  const double length = glm::distance(from, to);
  const int pieces = std::max(1, static_cast<int>(std::lround(length / kRailPiece)));
  const auto at = [&](int step, const glm::dvec2& side) {
    const double share = static_cast<double>(step) / pieces;
    return Corner{glm::mix(from, to, share) + glm::dvec3(0, side.x, side.y),
                  {share * length, side.x + side.y},
                  1};
  };
  const glm::dvec2 around[] = {{-kRail, kRail}, {kRail, kRail}, {kRail, -kRail}, {-kRail, -kRail}};
  for (int step = 0; step < pieces; ++step) {
    for (int i = 0; i < 4; ++i) {
      const glm::dvec2 &a = around[i], &b = around[(i + 1) % 4];
      mesh.flatQuad(at(step, a), at(step + 1, a), at(step + 1, b), at(step, b));
    }
  }
}

void raisePost(const glm::dvec3& foot, double height, MeshBuilder& mesh) {
  mesh.box(foot - glm::dvec3(kPost, 0, kPost), foot + glm::dvec3(kPost, height, kPost), "XxYZz");
  const double top = foot.y + height, cap = 1.25 * kPost;
  mesh.box({foot.x - cap, top, foot.z - cap}, {foot.x + cap, top + 0.035, foot.z + cap}, "XxyYZz");
}

/// A handrail on turned balusters along x, `rise` higher at its +x end, a newel post at each end.
Shape makeBalustrade(const ShapeNumbers& n) {
  const double half = 0.5 * n.at("length"), height = n.at("height"), rise = n.at("rise");
  const auto levelAt = [=](double x) { return rise * (x + half) / (2 * half); };
  const int count = std::max(1, static_cast<int>(std::lround(2 * half / n.at("spacing"))) - 1);
  // Radius and height, both shares, from the foot up: square-edged foot, vase, neck, head.
  const auto profile = std::make_shared<const ProfileCurve>(kBalusterProfile);
  Shape shape;
  for (int i = 1; i <= count; ++i) {
    const double x = -half + 2 * half * i / (count + 1);
    shape.surfaces.push_back(balusterAt({x, levelAt(x), 0}, height - kRail, profile));
  }
  shape.flat = [=](MeshBuilder& mesh) {
    raiseRail({-half, height, 0}, {half, rise + height, 0}, mesh);
    raisePost({-half, 0, 0}, height + kPostHigher, mesh);
    raisePost({half, rise, 0}, height + kPostHigher, mesh);
  };
  return shape;
}

}  // namespace

std::vector<ShapeKind> stairwayKinds() {
  return {
      {"stairs",
       0,
       {{"height", 2.8, 0.3, 20},
        {"run", 4, 0.3, 30},
        {"width", 1, 0.3, 10},
        {"steps", 16, 2, 100}},
       makeStairs},
      {"balustrade",
       6000,
       {{"length", 2, 0.3, 30},
        {"height", 0.9, 0.3, 2},
        {"rise", 0, -20, 20},
        {"spacing", 0.13, 0.08, 1}},
       makeBalustrade},
  };
}

}  // namespace enfilade
