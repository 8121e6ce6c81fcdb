#include "models/raise_trim.h"

#include <algorithm>

#include "models/polygon.h"

namespace enfilade {
namespace {

constexpr double kArchitraveWidth = 0.11;  // [m]
constexpr double kArchitraveDepth = 0.035;
constexpr double kArchitraveSetback = 0.012;  // its inner edge from the jamb
constexpr double kTextureSize = 0.5;

/// A stretch of an edge that the profile covers, and whether it ends at a corner.
struct Stretch {
  double start = 0, end = 0;
  bool from_corner = false, to_corner = false;
};

std::vector<Stretch> stretches(const PlanStorey& plan, const LayoutEdge& edge, const Layout& layout,
                               TrimGaps gaps) {
  std::vector<Stretch> result{{0, edge.length(), true, true}};
  if (gaps == TrimGaps::kNowhere) return result;
  const double beside = kArchitraveSetback + 0.9 * kArchitraveWidth;
  for (const EdgeOpening& o : edge.openings) {
    if (plan.openings[layout.openings[o.opening].plan].sill > 0) continue;
    result.back().end = o.start - beside;
    result.back().to_corner = false;
    result.push_back({o.end + beside, edge.length(), false, true});
  }
  std::erase_if(result, [](const Stretch& s) { return s.end - s.start < 0.02; });
  return result;
}

double shadeOf(const TrimProfile& profile, std::size_t i) {
  // Hollows gather shade: darker near the wall.
  double deepest = 0;
  for (const glm::dvec2& p : profile) deepest = std::max(deepest, p.x);
  return 0.75 + 0.25 * profile[i].x / deepest;
}

/// Where an architrave stands on its wall: `along` and `up` [m] from the foot of its first jamb.
struct WallFrame {
  glm::dvec2 origin, direction, inward;
  double foot = 0;

  Corner at(double along, double up, double out, double shade) const {
    const glm::dvec2 p = origin + direction * along + inward * out;
    return {{p.x, foot + up, p.y}, glm::dvec2(along, -up) / kTextureSize, shade};
  }
};

struct FrameProfilePoint {
  double away, out, shade;  // from the opening's edge, from the wall
};

constexpr FrameProfilePoint kFrameProfile[] = {
    {kArchitraveSetback, 0, 0.8},
    {kArchitraveSetback, 0.6 * kArchitraveDepth, 0.95},
    {kArchitraveSetback + 0.04, 0.6 * kArchitraveDepth, 0.85},
    {kArchitraveSetback + 0.05, kArchitraveDepth, 1},
    {kArchitraveSetback + kArchitraveWidth, kArchitraveDepth, 1},
    {kArchitraveSetback + kArchitraveWidth, 0, 0.75},
};

void raiseArchitrave(const WallFrame& frame, double width, double height, bool all_round,
                     MeshBuilder& mesh) {
  // Corners of the path around the opening, first jamb's foot to second jamb's foot.
  const auto corner = [&](std::size_t k, const FrameProfilePoint& p) {
    const double foot = all_round ? -p.away : 0;
    const double along = k == 0 || k == 1 ? -p.away : width + p.away;
    const double up = k == 1 || k == 2 ? height + p.away : foot;
    return frame.at(along, up, p.out, p.shade);
  };
  const std::size_t segments = all_round ? 4 : 3;
  for (std::size_t k = 0; k < segments; ++k) {
    for (std::size_t i = 0; i + 1 < std::size(kFrameProfile); ++i) {
      const std::size_t next = (k + 1) % 4;
      mesh.flatQuad(corner(k, kFrameProfile[i]), corner(next, kFrameProfile[i]),
                    corner(next, kFrameProfile[i + 1]), corner(k, kFrameProfile[i + 1]));
    }
  }
}

}  // namespace

TrimProfile skirtingProfile(double floor) {
  return {{0.022, floor}, {0.022, floor + 0.13}, {0.012, floor + 0.155}, {0, floor + 0.155}};
}

TrimProfile corniceProfile(double ceiling) {
  return {{0, ceiling - 0.19},     {0.03, ceiling - 0.19},  {0.035, ceiling - 0.15},
          {0.08, ceiling - 0.075}, {0.13, ceiling - 0.045}, {0.15, ceiling - 0.045},
          {0.15, ceiling}};
}

TrimProfile facadeCorniceProfile(double level) {
  return {{0, level - 0.30},    {0.06, level - 0.30}, {0.08, level - 0.2}, {0.2, level - 0.08},
          {0.26, level - 0.08}, {0.26, level},        {0, level + 0.02}};
}

TrimProfile plinthProfile(double ground) {
  return {{0.05, ground - 0.2}, {0.05, ground + 0.4}, {0, ground + 0.44}};
}

void raiseTrim(const PlanStorey& plan, const Outline& outline, const Layout& layout,
               const TrimProfile& profile, TrimGaps gaps, MeshBuilder& mesh) {
  const auto corners = outline.corners();
  std::vector<std::vector<glm::dvec2>> moved;
  for (const glm::dvec2& p : profile) moved.push_back(inset(corners, p.x));
  for (std::size_t e = 0; e < outline.edges.size(); ++e) {
    const LayoutEdge& edge = outline.edges[e];
    const auto at = [&](std::size_t i, double along, bool corner, std::size_t which) {
      const glm::dvec2 p =
          corner ? moved[i][which] : edge.point(along) + edge.inward * profile[i].x;
      const double s = glm::dot(p - edge.from, edge.direction());
      return Corner{{p.x, profile[i].y, p.y},
                    glm::dvec2(s, profile[i].x - profile[i].y) / kTextureSize,
                    shadeOf(profile, i)};
    };
    for (const Stretch& s : stretches(plan, edge, layout, gaps)) {
      const std::size_t next = (e + 1) % corners.size();
      for (std::size_t i = 0; i + 1 < profile.size(); ++i)
        mesh.flatQuad(at(i, s.start, s.from_corner, e), at(i, s.end, s.to_corner, next),
                      at(i + 1, s.end, s.to_corner, next), at(i + 1, s.start, s.from_corner, e));
    }
  }
}

void raiseArchitraves(const PlanStorey& plan, const Outline& outline, const Layout& layout,
                      MeshBuilder& mesh) {
  for (const LayoutEdge& edge : outline.edges) {
    for (const EdgeOpening& o : edge.openings) {
      const OpeningSide& side = layout.openings[o.opening].sides[static_cast<std::size_t>(o.side)];
      const PlanOpening& opening = plan.openings[layout.openings[o.opening].plan];
      const WallFrame frame{side.first, edge.direction(), side.inward, plan.floor + opening.sill};
      raiseArchitrave(frame, opening.width, opening.head - opening.sill, opening.sill > 0, mesh);
    }
  }
}

}  // namespace enfilade
