#include "models/raise_walls.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

constexpr double kShadeReach = 0.7;  // corners darken the wall this far [m]
constexpr double kDarkest = 0.74;    // in the corner itself
constexpr double kThresholdShade = 0.8;

double shadeAt(double along, double length) {
  const double near = std::min({along, length - along, kShadeReach}) / kShadeReach;
  return kDarkest + (1 - kDarkest) * std::sqrt(near);
}

std::vector<WallBreak> edgeBreaks(const LayoutEdge& edge, const Layout& layout,
                                  bool shade_corners) {
  const double length = edge.length();
  std::vector<WallBreak> breaks{{0, edge.from, 1}, {length, edge.to, 1}};
  for (const EdgeOpening& o : edge.openings) {
    const OpeningSide& side = layout.openings[o.opening].sides[static_cast<std::size_t>(o.side)];
    breaks.push_back({o.start, side.first, 1});
    breaks.push_back({o.end, side.second, 1});
  }
  if (shade_corners && length > 3 * kShadeReach) {
    for (const double s :
         {0.12, 0.35, kShadeReach, length - kShadeReach, length - 0.35, length - 0.12}) {
      const bool in_the_way =
          std::any_of(edge.openings.begin(), edge.openings.end(),
                      [&](const EdgeOpening& o) { return s > o.start - 0.1 && s < o.end + 0.1; });
      if (!in_the_way) breaks.push_back({s, edge.point(s), 1});
    }
  }
  std::sort(breaks.begin(), breaks.end(),
            [](const WallBreak& a, const WallBreak& b) { return a.along < b.along; });
  if (shade_corners)
    for (WallBreak& b : breaks) b.shade = shadeAt(b.along, length);
  return breaks;
}

/// One column of wall between two breaks, and the heights at which each side has vertices.
class ColumnRaiser {
 public:
  ColumnRaiser(const PlanStorey& plan, const Layout& layout, const LayoutEdge& edge,
               const WallExtent& extent, MeshBuilder& mesh)
      : plan_(plan), layout_(layout), edge_(edge), extent_(extent), mesh_(mesh) {}

  void raise(const WallBreak& left, const WallBreak& right) {
    double from = extent_.bottom;
    const double middle = 0.5 * (left.along + right.along);
    for (const EdgeOpening& o : edge_.openings) {
      if (middle < o.start || middle > o.end) continue;
      const PlanOpening& opening = planOf(o);
      const double sill = extent_.floor + opening.sill;
      if (sill > from) raiseBand(left, right, from, sill);
      from = extent_.floor + opening.head;
    }
    raiseBand(left, right, from, extent_.top);
  }

 private:
  const PlanOpening& planOf(const EdgeOpening& o) const {
    return plan_.openings[layout_.openings[o.opening].plan];
  }

  /// From `low` to `high`, with the sills and heads of the openings that begin or end at `at`.
  std::vector<double> heightsAt(const WallBreak& at, double low, double high) const {
    std::vector<double> heights{low, high};
    for (const EdgeOpening& o : edge_.openings) {
      if (std::abs(o.start - at.along) > 1e-9 && std::abs(o.end - at.along) > 1e-9) continue;
      for (const double h : {planOf(o).sill, planOf(o).head})
        if (extent_.floor + h > low && extent_.floor + h < high)
          heights.push_back(extent_.floor + h);
    }
    std::sort(heights.begin(), heights.end());
    return heights;
  }

  std::uint32_t vertexAt(const WallBreak& at, double y) {
    const Corner corner{{at.point.x, y, at.point.y},
                        {at.along / extent_.across, 1 - (y - extent_.foot) / extent_.up},
                        at.shade};
    return mesh_.vertex(corner, {edge_.inward.x, 0, edge_.inward.y});
  }

  /// Zips the two sides together, always advancing the lower one.
  void raiseBand(const WallBreak& left, const WallBreak& right, double low, double high) {
    std::vector<std::uint32_t> l, r;
    const auto left_heights = heightsAt(left, low, high),
               right_heights = heightsAt(right, low, high);
    for (const double y : left_heights) l.push_back(vertexAt(left, y));
    for (const double y : right_heights) r.push_back(vertexAt(right, y));
    std::size_t i = 0, j = 0;
    while (i + 1 < l.size() || j + 1 < r.size()) {
      const bool advance_right =
          j + 1 < r.size() && (i + 1 == l.size() || right_heights[j + 1] <= left_heights[i + 1]);
      if (advance_right) {
        mesh_.triangle(l[i], r[j], r[j + 1]);
        ++j;
      } else {
        mesh_.triangle(l[i], r[j], l[i + 1]);
        ++i;
      }
    }
  }

  const PlanStorey& plan_;
  const Layout& layout_;
  const LayoutEdge& edge_;
  const WallExtent& extent_;
  MeshBuilder& mesh_;
};

Corner revealCorner(const glm::dvec2& p, double y, const glm::dvec2& texcoord, double shade) {
  return {{p.x, y, p.y}, texcoord, shade};
}

}  // namespace

OutlineBreaks outlineBreaks(const Outline& outline, const Layout& layout, bool shade_corners) {
  OutlineBreaks breaks;
  for (const LayoutEdge& edge : outline.edges)
    breaks.push_back(edgeBreaks(edge, layout, shade_corners));
  return breaks;
}

void raiseWalls(const PlanStorey& plan, const Outline& outline, const Layout& layout,
                const OutlineBreaks& breaks, const WallExtent& extent, MeshBuilder& mesh) {
  for (std::size_t e = 0; e < outline.edges.size(); ++e) {
    ColumnRaiser columns(plan, layout, outline.edges[e], extent, mesh);
    for (std::size_t i = 0; i + 1 < breaks[e].size(); ++i)
      columns.raise(breaks[e][i], breaks[e][i + 1]);
  }
}

void raiseStoreyJoint(const Outline& outline, const OutlineBreaks& below, const Outline& above,
                      const OutlineBreaks& breaks_above, double low, double high,
                      const WallExtent& extent, MeshBuilder& mesh) {
  for (std::size_t e = 0; e < outline.edges.size(); ++e) {
    const LayoutEdge& edge = outline.edges[e];
    // The same edge may stand elsewhere in the upper outline's list.
    std::size_t upper = 0;
    for (std::size_t i = 1; i < above.edges.size(); ++i)
      if (glm::distance(above.edges[i].from, edge.from) <
          glm::distance(above.edges[upper].from, edge.from))
        upper = i;
    const std::vector<WallBreak>&l = below[e], &h = breaks_above[upper];
    const auto vertex = [&](const WallBreak& at, double y) {
      return mesh.vertex({{at.point.x, y, at.point.y},
                          {at.along / extent.across, 1 - (y - extent.foot) / extent.up},
                          at.shade},
                         {edge.inward.x, 0, edge.inward.y});
    };
    std::vector<std::uint32_t> lower, higher;
    for (const WallBreak& at : l) lower.push_back(vertex(at, low));
    for (const WallBreak& at : h) higher.push_back(vertex(at, high));
    for (std::size_t i = 0, j = 0; i + 1 < l.size() || j + 1 < h.size();) {
      const bool advance_lower =
          i + 1 < l.size() && (j + 1 == h.size() || l[i + 1].along <= h[j + 1].along);
      if (advance_lower) {
        mesh.triangle(lower[i], lower[i + 1], higher[j]);
        ++i;
      } else {
        mesh.triangle(lower[i], higher[j + 1], higher[j]);
        ++j;
      }
    }
  }
}

void raiseReveals(const PlanStorey& plan, const Outline& outline, const Layout& layout,
                  double reveal_size, double threshold_size, MeshBuilder& reveals,
                  MeshBuilder& thresholds) {
  for (const LayoutEdge& edge : outline.edges) {
    for (const EdgeOpening& o : edge.openings) {
      const OpeningSide& s = layout.openings[o.opening].sides[static_cast<std::size_t>(o.side)];
      const PlanOpening& opening = plan.openings[layout.openings[o.opening].plan];
      const double low = plan.floor + opening.sill, high = plan.floor + opening.head;
      const double deep = glm::distance(s.first, s.middle_first);
      const auto jamb = [&](const glm::dvec2& p, double y, double u, double shade) {
        return revealCorner(p, y, {u / reveal_size, -y / reveal_size}, shade);
      };
      reveals.flatQuad(jamb(s.first, low, 0, 0.95), jamb(s.middle_first, low, deep, 0.85),
                       jamb(s.middle_first, high, deep, 0.85), jamb(s.first, high, 0, 0.95));
      reveals.flatQuad(jamb(s.middle_second, low, deep, 0.85), jamb(s.second, low, 0, 0.95),
                       jamb(s.second, high, 0, 0.95), jamb(s.middle_second, high, deep, 0.85));
      const auto level = [&](const glm::dvec2& p, double y, double size, double shade) {
        return revealCorner(p, y, p / size, shade);
      };
      reveals.flatQuad(level(s.first, high, reveal_size, 0.95),
                       level(s.middle_first, high, reveal_size, 0.85),
                       level(s.middle_second, high, reveal_size, 0.85),
                       level(s.second, high, reveal_size, 0.95));
      const bool threshold = opening.sill == 0;
      MeshBuilder& mesh = threshold ? thresholds : reveals;
      const double size = threshold ? threshold_size : reveal_size;
      mesh.flatQuad(level(s.first, low, size, kThresholdShade),
                    level(s.second, low, size, kThresholdShade),
                    level(s.middle_second, low, size, kThresholdShade),
                    level(s.middle_first, low, size, kThresholdShade));
    }
  }
}

}  // namespace enfilade
