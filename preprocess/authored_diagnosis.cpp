#include "preprocess/authored_diagnosis.h"

#include <fmt/format.h>

#include <algorithm>

namespace enfilade {

namespace {

constexpr float kOverlap = 0.1f;  // of the smaller room's free space: more is told
constexpr float kWithin = 0.95f;  // of it: a room within a room, as it should be

void comparePortals(const AuthoredNames& names, CutCells& cells) {
  for (const auto& named : names.portals) {
    for (const Portal& portal : cells.graph.portals) {
      if (portal.polygon != named.portal.polygon) continue;
      const std::string& front = cells.graph.cells[portal.front].name;
      const std::string& back = cells.graph.cells[portal.back].name;
      const bool from_there = named.from.empty() || front == named.from || back == named.from;
      const bool to_there = named.to.empty() || front == named.to || back == named.to;
      if (!from_there || !to_there) {
        cells.log.push_back(fmt::format("{} is said to join {} and {}; it joins {} and {}",
                                        portal.name, named.from, named.to, front, back));
      } else if (!portal.two_way && !named.from.empty() && front != named.from) {
        cells.log.push_back(
            fmt::format("{} is one-way and faces away from {}: it is seen through from {} only",
                        portal.name, named.from, front));
      }
    }
  }
}

void checkRooms(const AuthoredNames& names, CutCells& cells) {
  for (const auto& room : names.rooms) {
    const auto cell = std::find_if(cells.graph.cells.begin(), cells.graph.cells.end(),
                                   [&](const Cell& c) { return c.name == room.name; });
    if (cell == cells.graph.cells.end()) {
      cells.log.push_back(
          fmt::format("{} is no cell: it has no free space, or is one with another", room.name));
    } else if (cell->portals.empty()) {
      cells.log.push_back(fmt::format("no portal leads to {}", room.name));
    }
  }
}

/// Free voxels in both rooms, and in the first.
std::pair<std::size_t, std::size_t> sharedVoxels(const AuthoredNames::Room& a,
                                                 const AuthoredNames::Room& b,
                                                 const VoxelGrid& grid) {
  std::size_t both = 0, first = 0;
  if (a.bounds.empty()) return {0, 0};
  const glm::ivec3 from = glm::max(grid.voxelOf(a.bounds.min), glm::ivec3(0));
  const glm::ivec3 to = glm::min(grid.voxelOf(a.bounds.max), grid.size - 1);
  for (int x = from.x; x <= to.x; ++x) {
    for (int z = from.z; z <= to.z; ++z) {
      for (int y = from.y; y <= to.y; ++y) {
        if (grid.bits[grid.index(x, y, z)] & kVoxelSolid) continue;
        const glm::vec3 p = grid.centerOf({x, y, z});
        if (!a.withinPlanes(p)) continue;
        ++first;
        both += b.bounds.contains(p) && b.withinPlanes(p);
      }
    }
  }
  return {both, first};
}

void findOverlaps(const AuthoredNames& names, const VoxelGrid& grid, CutCells& cells) {
  const float volume = grid.voxel * grid.voxel * grid.voxel;
  for (std::size_t i = 0; i < names.rooms.size(); ++i) {
    for (std::size_t j = i + 1; j < names.rooms.size(); ++j) {
      const AuthoredNames::Room &a = names.rooms[i], &b = names.rooms[j];
      if (!a.bounds.overlaps(b.bounds)) continue;
      const auto [in_b, in_a] = sharedVoxels(a, b, grid);
      if (in_b == 0) continue;
      const auto [again, of_b] = sharedVoxels(b, a, grid);
      const float share = float(in_b) / float(std::max<std::size_t>(std::min(in_a, of_b), 1));
      if (share < kOverlap || share > kWithin) continue;
      cells.log.push_back(fmt::format(
          "{} and {} overlap by {:.1f} m³, {:.0f} % of the smaller, which keeps it; a NAME-bound "
          "tells them apart",
          a.name, b.name, float(in_b) * volume, 100 * share));
    }
  }
}

}  // namespace

void diagnoseAuthored(const AuthoredNames& names, const VoxelGrid& voxels, CutCells& cells) {
  comparePortals(names, cells);
  checkRooms(names, cells);
  findOverlaps(names, voxels, cells);
}

}  // namespace enfilade
