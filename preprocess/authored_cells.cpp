#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "preprocess/authored_names.h"

namespace enfilade {

namespace {

// Floors closer than this are one storey [m].
constexpr float kStoreyStep = 1.5f;

float floorOf(const AuthoredNames::Room& room) {
  return room.bounds.empty() ? room.position.y : room.bounds.min.y;
}

void nameStoreys(const AuthoredNames& names, CellProposal& proposal) {
  std::vector<float> floors;
  for (const auto& room : names.rooms) floors.push_back(floorOf(room));
  std::sort(floors.begin(), floors.end());
  for (const float floor : floors) {
    if (!proposal.storeys.empty() && floor < proposal.storeys.back().floor_y + kStoreyStep)
      continue;
    proposal.storeys.push_back({fmt::format("storey-{}", proposal.storeys.size()), floor});
  }
  proposal.cell_names.push_back("exterior");
  proposal.cell_storeys.push_back(0);
  for (const auto& room : names.rooms) {
    int storey = 0;
    for (std::size_t s = 0; s < proposal.storeys.size(); ++s) {
      if (proposal.storeys[s].floor_y <= floorOf(room) + 1e-3f) storey = static_cast<int>(s);
    }
    proposal.cell_names.push_back(room.name);
    proposal.cell_storeys.push_back(storey);
  }
}

// Smaller rooms first: a room within a room's box keeps its own voxels.
std::vector<std::size_t> bySize(const AuthoredNames& names) {
  std::vector<std::size_t> order(names.rooms.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto volume = [&](std::size_t r) {
    const glm::vec3 size = names.rooms[r].bounds.size();
    return size.x * size.y * size.z;
  };
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return volume(a) < volume(b); });
  return order;
}

void giveVoxels(const AuthoredNames& names, const VoxelGrid& grid, CellProposal& proposal) {
  proposal.owner.assign(grid.bits.size(), CellProposal::kNobody);
  for (const std::size_t r : bySize(names)) {
    const auto& room = names.rooms[r];
    if (room.bounds.empty()) continue;
    const glm::ivec3 first = glm::max(grid.voxelOf(room.bounds.min), glm::ivec3(0));
    const glm::ivec3 last = glm::min(grid.voxelOf(room.bounds.max), grid.size - 1);
    for (int x = first.x; x <= last.x; ++x) {
      for (int z = first.z; z <= last.z; ++z) {
        for (int y = first.y; y <= last.y; ++y) {
          const std::size_t i = grid.index(x, y, z);
          if ((grid.bits[i] & kVoxelSolid) || proposal.owner[i] != CellProposal::kNobody) continue;
          if (room.withinPlanes(grid.centerOf({x, y, z}))) {
            proposal.owner[i] = static_cast<std::uint16_t>(r + 1);
          }
        }
      }
    }
  }
}

}  // namespace

bool AuthoredNames::Room::withinPlanes(const glm::vec3& p) const {
  return std::all_of(bound_planes.begin(), bound_planes.end(),
                     [&](const Plane& plane) { return plane.signedDistance(p) >= 0; });
}

std::vector<Portal> authoredPortals(const AuthoredNames& names) {
  std::vector<Portal> portals;
  for (const auto& named : names.portals) {
    Portal portal = named.portal;
    portal.plane = planeOf(portal.polygon);
    portals.push_back(std::move(portal));
  }
  return portals;
}

CellProposal authoredCells(const AuthoredNames& names, const VoxelGrid& voxels) {
  CellProposal proposal;
  nameStoreys(names, proposal);
  giveVoxels(names, voxels, proposal);
  proposal.portals = authoredPortals(names);
  proposal.log = names.warnings;
  return proposal;
}

}  // namespace enfilade
