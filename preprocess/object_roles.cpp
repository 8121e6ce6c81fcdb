#include "preprocess/object_roles.h"

#include <fmt/format.h>

#include <algorithm>

namespace enfilade {

namespace {

constexpr float kBeside = 0.4f;  // [m] about a portal, where its door may stand

std::vector<Box> placesOfDoors(const CellGraph& graph) {
  std::vector<Box> places;
  for (const Portal& portal : graph.portals) {
    Box box;
    for (const glm::vec3& p : portal.polygon) box.extend(p);
    places.push_back(box.grown(kBeside));
  }
  return places;
}

}  // namespace

std::vector<ObjectRole> namedRoles(const Building& building, const std::string& doors,
                                   const std::string& windows) {
  const std::vector<std::uint8_t> are_doors = matchNames(building, doors);
  const std::vector<std::uint8_t> are_windows = matchNames(building, windows);
  std::vector<ObjectRole> roles;
  for (std::size_t o = 0; o < building.objects.size(); ++o) {
    roles.push_back(are_doors[o] != 0     ? ObjectRole::kDoor
                    : are_windows[o] != 0 ? ObjectRole::kGlass
                                          : ObjectRole::kFixed);
  }
  return roles;
}

void fixDoorsWithoutPortals(const Building& building, CutCells& cells,
                            std::vector<ObjectRole>& roles) {
  const std::vector<Box> places = placesOfDoors(cells.graph);
  int fixed = 0;
  for (std::size_t o = 0; o < roles.size(); ++o) {
    if (roles[o] != ObjectRole::kDoor) continue;
    const Box bounds = worldBounds(building, building.objects[o]);
    if (std::any_of(places.begin(), places.end(),
                    [&](const Box& place) { return place.overlaps(bounds); })) {
      continue;
    }
    roles[o] = ObjectRole::kFixed;
    ++fixed;
  }
  if (fixed > 0) {
    cells.log.push_back(
        fmt::format("{} objects are called doors but stand in no portal: they are drawn", fixed));
  }
}

}  // namespace enfilade
