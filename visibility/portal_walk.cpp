#include "visibility/portal_walk.h"

#include <algorithm>
#include <limits>

namespace enfilade {

PortalWalker::PortalWalker(const CellGraph& graph, float tolerance) : tolerance_(tolerance) {
  first_.push_back(0);
  for (CellId id = 0; id < graph.cells.size(); ++id) {
    for (const PortalId portal_id : graph.cells[id].portals) {
      const Portal& portal = graph.portals[portal_id];
      const bool from_front = portal.front == id;
      Side side;
      side.plane = from_front ? portal.plane : Plane{-portal.plane.normal, -portal.plane.d};
      side.portal = portal_id;
      side.behind = portal.cellBehind(from_front);
      side.from_front = from_front;
      side.first_edge = static_cast<std::uint32_t>(edges_.size());
      for (std::size_t i = 0; i < portal.polygon.size(); ++i) {
        const glm::vec3& a = portal.polygon[i];
        const glm::vec3 edge = portal.polygon[(i + 1) % portal.polygon.size()] - a;
        if (glm::dot(edge, edge) == 0) continue;
        const glm::vec3 inward = glm::normalize(glm::cross(portal.plane.normal, edge));
        edges_.push_back({inward, -glm::dot(inward, a)});
      }
      side.last_edge = static_cast<std::uint32_t>(edges_.size());
      sides_.push_back(side);
    }
    first_.push_back(static_cast<std::uint32_t>(sides_.size()));
  }
}

CellId PortalWalker::walk(CellId start, const glm::vec3& origin, const glm::vec3& direction,
                          float distance, std::vector<PortalCrossing>& crossings) const {
  crossings.clear();
  CellId cell = start;
  float reached = 0;
  while (true) {
    const Side* next = nullptr;
    float nearest = distance;
    for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) {
      const Side& side = sides_[i];
      const float approach = -glm::dot(side.plane.normal, direction);
      const float ahead = side.plane.signedDistance(origin);
      // Away from this cell, and not behind what has been reached, but for the tolerance.
      if (!(approach > 0) || ahead - reached * approach < -tolerance_) continue;
      const float t = ahead / approach;
      if (!(t < nearest)) continue;
      const glm::vec3 hit = origin + t * direction;
      const auto inside = [&](const Plane& edge) {
        return edge.signedDistance(hit) >= -tolerance_;
      };
      if (!std::all_of(edges_.begin() + side.first_edge, edges_.begin() + side.last_edge, inside)) {
        continue;
      }
      // Portals within the tolerance of each other must not send the segment round in circles.
      const auto passed = [&](const PortalCrossing& c) { return c.portal == side.portal; };
      if (std::any_of(crossings.begin(), crossings.end(), passed)) continue;
      nearest = t;
      next = &side;
    }
    if (next == nullptr) return cell;
    crossings.push_back({next->portal, next->from_front, nearest});
    reached = std::max(reached, nearest);
    cell = next->behind;
  }
}

}  // namespace enfilade
