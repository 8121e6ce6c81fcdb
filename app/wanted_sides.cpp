#include "app/wanted_sides.h"

#include <algorithm>

#include "portals/polygon.h"

namespace enfilade {

namespace {

/// The nearest first; of sides as near the first, so that the order is always the same.
void sortByDistance(const House& house, const glm::vec3& eye, std::span<std::size_t> sides) {
  std::vector<std::pair<float, std::size_t>> keyed;
  for (const std::size_t side : sides) {
    const Portal& portal = house.graph.portals[side / 2];
    keyed.emplace_back(distanceToPolygon(portal.polygon, portal.plane, eye), side);
  }
  std::sort(keyed.begin(), keyed.end());
  std::transform(keyed.begin(), keyed.end(), sides.begin(), [](auto& pair) { return pair.second; });
}

/// Marks the cells of `set` and those next to them.
std::vector<std::uint8_t> cellsAround(const CellGraph& graph, const VisibleSet& set) {
  std::vector<std::uint8_t> around(graph.cells.size(), 0);
  for (const VisibleCell& visible : set.cells) {
    around[visible.cell] = 1;
    for (const PortalId id : graph.cells[visible.cell].portals) {
      const Portal& portal = graph.portals[id];
      around[portal.cellBehind(portal.front == visible.cell)] = 1;
    }
  }
  return around;
}

}  // namespace

void findWantedSides(const House& house, const VisibleSet& set, const glm::vec3& eye,
                     WantedSides& wanted) {
  wanted.sides.clear();
  std::vector<std::uint8_t> listed(2 * house.graph.portals.size(), 0);
  for (const VisiblePortal& visible : set.portals) {
    if (!house.graph.portals[visible.portal].active ||
        !isBeyondSwitch(house, eye, visible.portal, visible.from_front)) {
      continue;
    }
    const std::size_t side = sideIndex(visible.portal, visible.from_front);
    wanted.sides.push_back(side);
    listed[side] = 1;
  }
  wanted.in_view = wanted.sides.size();
  const std::vector<std::uint8_t> around = cellsAround(house.graph, set);
  for (PortalId id = 0; id < house.graph.portals.size(); ++id) {
    const Portal& portal = house.graph.portals[id];
    for (const bool from_front : {true, false}) {
      const std::size_t side = sideIndex(id, from_front);
      const bool near = around[from_front ? portal.front : portal.back] != 0;
      if (near && !listed[side]) wanted.sides.push_back(side);
    }
  }
  const std::span<std::size_t> all(wanted.sides);
  sortByDistance(house, eye, all.first(wanted.in_view));
  sortByDistance(house, eye, all.subspan(wanted.in_view));
}

}  // namespace enfilade
