#include "app/door_timeline.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "portals/open_doors.h"
#include "portals/portal_names.h"

namespace enfilade {

void moveDoors(const std::string& names, bool open, const std::vector<std::uint8_t>& closable,
               ErrorKind kind, const std::string& source, CellGraph& graph) {
  const std::vector<PortalId> meant = portalsNamed(graph, names);
  if (meant.empty()) {
    throw Error(
        kind, source,
        fmt::format("no portal is called '{}'; 'enfilade inspect HOUSE' lists them", names));
  }
  bool moved = false;
  for (const PortalId id : meant) {
    if (!closable[id]) continue;
    // A door that leads to several cells is a portal for each pair of them.
    for (Portal& portal : graph.portals) {
      if (portal.polygon == graph.portals[id].polygon) portal.active = open;
    }
    moved = true;
  }
  if (!moved) {
    throw Error(kind, source, fmt::format("'{}' has no door's leaf that could be moved", names));
  }
}

std::vector<std::uint8_t> doorsOf(const CellGraph& graph) {
  std::vector<std::uint8_t> open;
  for (const Portal& portal : graph.portals) open.push_back(portal.active);
  return open;
}

DoorTimeline::DoorTimeline(const CameraPath& path, const House& house, const std::string& file) {
  if (path.doors.empty()) return;
  const std::vector<std::uint8_t> closable = closablePortals(house);
  CellGraph graph = house.graph;
  doors_.push_back({-std::numeric_limits<double>::infinity(), doorsOf(graph)});
  for (std::size_t e = 0; e < path.doors.size(); ++e) {
    const DoorEvent& event = path.doors[e];
    moveDoors(event.portal, event.open, closable, ErrorKind::kBadInput,
              fmt::format("{}: doors[{}]", file, e), graph);
    if (doors_.back().time < event.time) doors_.push_back({event.time, {}});
    doors_.back().open = doorsOf(graph);
  }
}

const std::vector<std::uint8_t>* DoorTimeline::at(double time) const noexcept {
  const auto next = std::upper_bound(doors_.begin(), doors_.end(), time,
                                     [](double t, const Doors& d) { return t < d.time; });
  return next == doors_.begin() ? nullptr : &std::prev(next)->open;
}

}  // namespace enfilade
