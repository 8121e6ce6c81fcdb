#include "models/raise_slabs.h"

#include <algorithm>
#include <cmath>

#include "models/polygon.h"
#include "models/polygon_holes.h"
#include "scene/polygon_triangles.h"

namespace enfilade {
namespace {

constexpr double kLeastLedge = 0.01;  // between a hole and the shaded edge of a slab [m]

/// Level triangles that face up or down, whichever way they are given.
class LevelMesh {
 public:
  LevelMesh(double level, SlabSide side, double size, MeshBuilder& mesh)
      : level_(level), side_(side), size_(size), mesh_(mesh) {}

  std::uint32_t vertex(const glm::dvec2& p, double shade) {
    return mesh_.vertex({{p.x, level_, p.y}, p / size_, shade},
                        {0, side_ == SlabSide::kTop ? 1 : -1, 0});
  }

  /// `a`, `b`, `c` of positive area in the plan.
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (side_ == SlabSide::kTop) std::swap(b, c);
    mesh_.triangle(a, b, c);
  }

  /// Fills between the chain `outer` and the segment from `a` to `b` on its left.
  void strip(const std::vector<std::uint32_t>& outer, std::size_t half, std::uint32_t a,
             std::uint32_t b) {
    for (std::size_t i = 0; i < half; ++i) triangle(outer[i], outer[i + 1], a);
    triangle(outer[half], b, a);
    for (std::size_t i = half; i + 1 < outer.size(); ++i) triangle(outer[i], outer[i + 1], b);
  }

 private:
  double level_;
  SlabSide side_;
  double size_;
  MeshBuilder& mesh_;
};

/// The break nearest to the middle of the edge.
std::size_t middleBreak(const std::vector<WallBreak>& breaks) {
  const double middle = 0.5 * breaks.back().along;
  std::size_t best = 0;
  for (std::size_t i = 1; i < breaks.size(); ++i)
    if (std::abs(breaks[i].along - middle) < std::abs(breaks[best].along - middle)) best = i;
  return best;
}

/// Whether the holes lie inside and off the edges, where nothing thin is left.
bool allInside(const std::vector<glm::dvec2>& polygon,
               const std::vector<std::vector<glm::dvec2>>& holes) {
  for (const auto& hole : holes) {
    for (const glm::dvec2& p : hole) {
      if (!containsPoint(polygon, p)) return false;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a = polygon[i], along = polygon[(i + 1) % polygon.size()] - a;
        const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
        if (glm::distance(p, a + t * along) < kLeastLedge) return false;
      }
    }
  }
  return true;
}

std::vector<glm::dvec2> validInset(const std::vector<glm::dvec2>& polygon, double width,
                                   const std::vector<std::vector<glm::dvec2>>& holes) {
  auto inner = inset(polygon, width);
  while (!isInsetValid(polygon, inner) || !allInside(inner, holes))
    inner = inset(polygon, width *= 0.5);
  return inner;
}

}  // namespace

void raiseSlab(const Outline& outline, const OutlineBreaks& breaks, const SlabLook& look,
               MeshBuilder& mesh) {
  LevelMesh level(look.level, look.side, look.size, mesh);
  const auto inner = validInset(outline.corners(), look.edge_width, look.holes);
  std::vector<std::uint32_t> inner_vertices;
  for (const glm::dvec2& p : inner) inner_vertices.push_back(level.vertex(p, 1));
  for (std::size_t e = 0; e < breaks.size(); ++e) {
    std::vector<std::uint32_t> outer;
    for (const WallBreak& b : breaks[e])
      outer.push_back(level.vertex(b.point, look.edge_shade * b.shade));
    level.strip(outer, middleBreak(breaks[e]), inner_vertices[e],
                inner_vertices[(e + 1) % inner.size()]);
  }
  const auto joined = joinHoles(inner, look.holes);
  std::vector<std::uint32_t> vertices = inner_vertices;
  for (const auto& hole : look.holes)
    for (const glm::dvec2& p : hole) vertices.push_back(level.vertex(p, 1));
  std::vector<glm::dvec2> points;
  for (const JoinedCorner& corner : joined) points.push_back(corner.point);
  for (const auto& [a, b, c] : triangulate(points))
    level.triangle(vertices[joined[a].index], vertices[joined[b].index], vertices[joined[c].index]);
}

void raiseWell(const std::vector<glm::dvec2>& corners, double low, double high, double size,
               MeshBuilder& mesh) {
  double around = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double length = glm::distance(a, b);
    const auto at = [&](const glm::dvec2& p, double along, double y) {
      return Corner{{p.x, y, p.y}, glm::dvec2(around + along, -y) / size, 0.9};
    };
    mesh.flatQuad(at(a, 0, low), at(b, length, low), at(b, length, high), at(a, 0, high));
    around += length;
  }
}

void raiseRoof(const Outline& outline, const OutlineBreaks& breaks, double parapet_top,
               double roof_level, double parapet_width, double size, MeshBuilder& coping,
               MeshBuilder& roof) {
  // The building lies on the right of the exterior's edges, so the coping is inset by −width and
  // its triangles turn the other way: an underside that faces up.
  const auto corners = outline.corners();
  auto inner = inset(corners, -parapet_width);
  for (std::size_t e = 0; e < breaks.size(); ++e) {
    const glm::dvec2 a = inner[e], b = inner[(e + 1) % inner.size()];
    const auto at = [&](const glm::dvec2& p, double y) {
      return Corner{{p.x, y, p.y}, glm::dvec2(p.x + p.y, p.y - y) / size, 1};
    };
    const std::size_t half = middleBreak(breaks[e]);
    const auto tri = [&](const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
      coping.flatTriangle(at(p, parapet_top), at(q, parapet_top), at(r, parapet_top));
    };
    for (std::size_t i = 0; i < half; ++i) tri(breaks[e][i].point, breaks[e][i + 1].point, a);
    tri(breaks[e][half].point, b, a);
    for (std::size_t i = half; i + 1 < breaks[e].size(); ++i)
      tri(breaks[e][i].point, breaks[e][i + 1].point, b);
    coping.flatQuad(at(b, roof_level), at(a, roof_level), at(a, parapet_top), at(b, parapet_top));
  }
  std::reverse(inner.begin(), inner.end());
  LevelMesh level(roof_level, SlabSide::kTop, size, roof);
  std::vector<std::uint32_t> vertices;
  for (const glm::dvec2& p : inner) vertices.push_back(level.vertex(p, 1));
  for (const auto& [a, b, c] : triangulate(inner))
    level.triangle(vertices[a], vertices[b], vertices[c]);
}

void raiseGround(const Outline& outline, double level, double margin, double size,
                 MeshBuilder& mesh) {
  glm::dvec2 low(1e30), high(-1e30);
  for (const glm::dvec2& p : outline.corners()) {
    low = glm::min(low, p - margin);
    high = glm::max(high, p + margin);
  }
  LevelMesh ground(level, SlabSide::kTop, size, mesh);
  const std::uint32_t a = ground.vertex(low, 1), b = ground.vertex({high.x, low.y}, 1),
                      c = ground.vertex(high, 1), d = ground.vertex({low.x, high.y}, 1);
  ground.triangle(a, b, c);
  ground.triangle(a, c, d);
}

}  // namespace enfilade
