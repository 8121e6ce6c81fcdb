#include "app/walk.h"

#include <fmt/format.h>

#include <algorithm>

#include "portals/open_doors.h"
#include "portals/portal_names.h"

namespace enfilade {

namespace {

std::vector<std::uint8_t> activeOf(const CellGraph& graph) {
  std::vector<std::uint8_t> active;
  for (const Portal& portal : graph.portals) active.push_back(portal.active);
  return active;
}

}  // namespace

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

Walk::Walk(const CameraPath& path, const Camera& camera, const House& house,
           const std::string& file)
    : path_(path), camera_(camera) {
  if (path.doors.empty()) return;
  const std::vector<std::uint8_t> closable = closablePortals(house);
  CellGraph graph = house.graph;
  doors_.push_back({0, activeOf(graph)});
  auto first = path.poses.begin();
  for (std::size_t e = 0; e < path.doors.size(); ++e) {
    const DoorEvent& event = path.doors[e];
    moveDoors(event.portal, event.open, closable, ErrorKind::kBadInput,
              fmt::format("{}: doors[{}]", file, e), graph);
    first = std::find_if(first, path.poses.end(),
                         [&](const TimedPose& timed) { return timed.time >= event.time; });
    const auto frame = static_cast<std::size_t>(first - path.poses.begin());
    if (doors_.back().frame < frame) doors_.push_back({frame, {}});
    doors_.back().open = activeOf(graph);
  }
}

Camera Walk::stepTo(std::size_t frame, FramePainter& painter) const {
  const auto next = std::upper_bound(doors_.begin(), doors_.end(), frame,
                                     [](std::size_t f, const Doors& d) { return f < d.frame; });
  if (next != doors_.begin()) painter.setDoors(std::prev(next)->open);
  return cameraAt(path_, frame, camera_);
}

}  // namespace enfilade
