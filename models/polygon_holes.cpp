// Polygons with holes: Eberly, Triangulation by Ear Clipping, 2002, section 3.
#include "models/polygon_holes.h"

#include <algorithm>

#include "models/polygon.h"

namespace enfilade {
namespace {

using Outline = std::vector<JoinedCorner>;

/// Whether the inner parts of two segments cross.
bool cross(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d) {
  const auto side = [](const glm::dvec2& p, const glm::dvec2& q, const glm::dvec2& r) {
    return planCross(q - p, r - p);
  };
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

bool crossesAny(const Outline& outline, const glm::dvec2& a, const glm::dvec2& b) {
  for (std::size_t i = 0; i < outline.size(); ++i)
    if (cross(a, b, outline[i].point, outline[(i + 1) % outline.size()].point)) return true;
  return false;
}

/// The corner of each outline where the shortest cut that meets no edge of `all` runs.
std::pair<std::size_t, std::size_t> shortestCut(const Outline& outer, const Outline& hole,
                                                const std::vector<Outline>& all) {
  std::pair<std::size_t, std::size_t> best{0, 0};
  double least = 1e300;
  for (std::size_t i = 0; i < outer.size(); ++i) {
    for (std::size_t j = 0; j < hole.size(); ++j) {
      const glm::dvec2 &a = outer[i].point, &b = hole[j].point;
      const double length = glm::distance(a, b);
      if (length >= least || crossesAny(outer, a, b)) continue;
      if (std::any_of(all.begin(), all.end(),
                      [&](const Outline& other) { return crossesAny(other, a, b); }))
        continue;
      least = length;
      best = {i, j};
    }
  }
  return best;
}

}  // namespace

std::vector<JoinedCorner> joinHoles(const std::vector<glm::dvec2>& outer,
                                    const std::vector<std::vector<glm::dvec2>>& holes) {
  Outline joined;
  std::size_t index = 0;
  for (const glm::dvec2& p : outer) joined.push_back({index++, p});
  std::vector<Outline> bays;
  for (const auto& hole : holes) {
    bays.emplace_back();
    for (const glm::dvec2& p : hole) bays.back().push_back({index++, p});
    // A hole's inside lies outside the polygon: it is gone round the other way.
    std::reverse(bays.back().begin(), bays.back().end());
  }
  for (Outline& bay : bays) {
    const auto [at, first] = shortestCut(joined, bay, bays);
    std::rotate(bay.begin(), bay.begin() + static_cast<std::ptrdiff_t>(first), bay.end());
    Outline way = bay;
    way.push_back(bay.front());
    way.push_back(joined[at]);
    joined.insert(joined.begin() + static_cast<std::ptrdiff_t>(at) + 1, way.begin(), way.end());
  }
  return joined;
}

}  // namespace enfilade
