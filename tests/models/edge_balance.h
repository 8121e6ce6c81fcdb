#pragma once

#include <gtest/gtest.h>

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "tests/models/test_geometry.h"

namespace enfilade {

/// Directed edges, counted; an edge and its reverse cancel out.  What is closed leaves none open.
class EdgeBalance {
 public:
  void add(const glm::vec3& a, const glm::vec3& b) {
    const Point p{a.x, a.y, a.z}, q{b.x, b.y, b.z};
    p < q ? ++balance_[{p, q}] : --balance_[{q, p}];
  }
  void add(const WorldTriangle& t) {
    add(t.a, t.b);
    add(t.b, t.c);
    add(t.c, t.a);
  }
  /// The quads of the portals into `room`, turned to face it.
  void addPortals(const std::vector<NamedPortal>& portals, const std::string& room) {
    for (const NamedPortal& p : portals) {
      const bool states = p.room == room + "-room";
      if (!states && p.to != room) continue;
      for (int i = 0; i < 4; ++i) {
        const glm::vec3 &a = p.corners[i], &b = p.corners[(i + 1) % 4];
        states ? add(a, b) : add(b, a);
      }
    }
  }
  std::vector<std::pair<glm::vec3, glm::vec3>> open() const {
    std::vector<std::pair<glm::vec3, glm::vec3>> edges;
    for (const auto& [edge, count] : balance_)
      if (count != 0) edges.push_back({pointOf(edge.first), pointOf(edge.second)});
    return edges;
  }

 private:
  using Point = std::tuple<float, float, float>;

  static glm::vec3 pointOf(const Point& p) {
    return {std::get<0>(p), std::get<1>(p), std::get<2>(p)};
  }

  std::map<std::pair<Point, Point>, int> balance_;
};

/// Expects that a room's walls, floor, ceiling and reveals are closed by the quads of its portals.
/// Returns how many triangles they have.
inline std::size_t expectClosed(const Building& building, const std::vector<NamedPortal>& portals,
                                const std::string& room) {
  EdgeBalance edges;
  const auto shell = worldTriangles(building, [&](const Object& object) {
    const std::string& name = building.nodes[object.node].name;
    return name == room + "-walls" || name == room + "-floor" || name == room + "-ceiling" ||
           name == room + "-reveals";
  });
  for (const WorldTriangle& t : shell) edges.add(t);
  edges.addPortals(portals, room);
  for (const auto& [a, b] : edges.open())
    ADD_FAILURE() << room << " is open from " << a.x << " " << a.y << " " << a.z << " to " << b.x
                  << " " << b.y << " " << b.z;
  return shell.size();
}

}  // namespace enfilade
