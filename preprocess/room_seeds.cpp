#include "preprocess/room_seeds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "preprocess/storey_plan.h"

namespace enfilade {

namespace {

constexpr float kVoidShare = 0.6f;  // of a room's plan without a floor: one with the room below

using Label = std::uint16_t;
constexpr Label kNobody = CellProposal::kNobody;

/// The plans of all storeys, and each basin's cell.
struct Rooms {
  std::vector<StoreyPlan> plans;
  std::vector<std::vector<Label>> labels;  ///< one a storey and basin; kNobody: too small
};

Label labelAt(const Rooms& rooms, std::size_t storey, std::size_t column) {
  const std::int32_t basin = rooms.plans[storey].basins.of_pixel[column];
  return basin == Basins::kNone ? kNobody : rooms.labels[storey][std::size_t(basin)];
}

/// For each basin of `storey`, how many of its columns have no floor, by the cell below them.
std::vector<std::map<Label, int>> countVoids(const Rooms& rooms, std::size_t storey) {
  const StoreyPlan& plan = rooms.plans[storey];
  const StoreyPlan& below = rooms.plans[storey - 1];
  std::vector<std::map<Label, int>> voids(plan.uses.size());
  for (std::size_t i = 0; i < plan.slice.kind.size(); ++i) {
    const std::int32_t basin = plan.basins.of_pixel[i];
    if (basin == Basins::kNone || plan.slice.low[i] >= plan.band.begin_y) continue;
    if (below.slice.kind[i] == ColumnKind::kWall || below.slice.high[i] < plan.band.begin_y)
      continue;
    const Label label = labelAt(rooms, storey - 1, i);
    if (label != kNobody) ++voids[std::size_t(basin)][label];
  }
  return voids;
}

/// Numbers the rooms of a storey, those that are the upper part of a room below as that one.
void labelStorey(float voxel, std::size_t storey, Rooms& rooms, RoomSeeds& seeds) {
  const StoreyPlan& plan = rooms.plans[storey];
  std::vector<std::map<Label, int>> voids(plan.uses.size());
  if (storey > 0) voids = countVoids(rooms, storey);
  auto& labels = rooms.labels.emplace_back(plan.uses.size(), kNobody);
  int merged = 0;
  for (std::size_t b = 0; b < plan.uses.size(); ++b) {
    if (plan.uses[b].use == PlanBasin::Use::kOutside) labels[b] = Label{kExterior};
    if (plan.uses[b].use != PlanBasin::Use::kRoom) continue;
    Label most = kNobody;
    int count = 0;
    for (const auto& [label, columns] : voids[b]) {
      if (columns > count) most = label, count = columns;
    }
    if (float(count) > kVoidShare * float(plan.uses[b].area)) {
      labels[b] = most;
      seeds.ranges[most].end_y = std::max(seeds.ranges[most].end_y, plan.band.end_y);
      seeds.widths[most] = std::max(seeds.widths[most], 2 * voxel * plan.basins.peak[b]);
      ++merged;
    } else {
      labels[b] = static_cast<Label>(seeds.storeys.size());
      seeds.storeys.push_back(static_cast<int>(storey));
      seeds.widths.push_back(2 * voxel * plan.basins.peak[b]);
      seeds.ranges.push_back({plan.band.begin_y, plan.band.end_y});
    }
  }
  if (merged > 0) {
    seeds.log.push_back("storey " + std::to_string(storey + 1) + ": " + std::to_string(merged) +
                        " voids are the upper part of what lies below them");
  }
}

/// Gives the runs at the slice to their cells.
void seedStorey(const VoxelGrid& voxels, const Rooms& rooms, std::size_t storey, RoomSeeds& seeds) {
  const StoreyPlan& plan = rooms.plans[storey];
  for (int x = 0; x < voxels.size.x; ++x) {
    for (int z = 0; z < voxels.size.z; ++z) {
      const std::size_t column = plan.slice.index(x, z);
      const Label label = labelAt(rooms, storey, column);
      if (label == kNobody) continue;
      int end = std::min(plan.slice.high[column], plan.band.end_y);
      if (label != kExterior && plan.slice.open_to_sky[column]) {
        end = std::min(end, plan.uses[std::size_t(plan.basins.of_pixel[column])].ceiling);
      }
      for (int y = std::max(plan.slice.low[column], plan.band.begin_y); y < end; ++y) {
        seeds.owner[voxels.index(x, y, z)] = label;
      }
    }
  }
}

/// Gives what lies open to the sky to the exterior, down to `lowest`.
void seedSky(const VoxelGrid& voxels, int lowest, RoomSeeds& seeds) {
  for (int x = 0; x < voxels.size.x; ++x) {
    for (int z = 0; z < voxels.size.z; ++z) {
      for (int y = voxels.size.y - 1; y >= lowest; --y) {
        const std::size_t v = voxels.index(x, y, z);
        if (voxels.bits[v] & (kVoxelSolid | kVoxelGlass)) break;
        if (seeds.owner[v] != kNobody && seeds.owner[v] != kExterior) break;
        seeds.owner[v] = Label{kExterior};
      }
    }
  }
}

std::string whatMakesARoom(const SmallRoom& room, const CellParameters& parameters) {
  std::string options;
  if (room.area < parameters.smallest_room) {
    options += fmt::format(" --smallest-room {:.1f}", std::floor(room.area * 10) / 10);
  }
  if (room.width < parameters.smallest_door) {
    options += fmt::format(" --smallest-door {:.1f}", std::floor(room.width * 10) / 10);
  }
  return options;
}

/// What the parameters would have to be for more rooms; the largest few of each storey.
void tellSmallRooms(const VoxelGrid& voxels, const CellParameters& parameters, std::size_t storey,
                    const StoreyPlan& plan, RoomSeeds& seeds) {
  constexpr std::size_t kMost = 3;
  const std::vector<SmallRoom> rooms = smallRooms(voxels, plan);
  for (std::size_t i = 0; i < std::min(kMost, rooms.size()); ++i) {
    seeds.log.push_back(fmt::format(
        "storey {}: {:.1f} m² at ({:.1f}, {:.1f}) are no room;{} makes them one", storey + 1,
        rooms[i].area, rooms[i].at.x, rooms[i].at.y, whatMakesARoom(rooms[i], parameters)));
  }
  if (rooms.size() > kMost) {
    seeds.log.push_back(
        fmt::format("storey {}: {} more are smaller still", storey + 1, rooms.size() - kMost));
  }
}

/// What --merge-ratio would have to be for a room to be two; the few nearest to it.
void tellWideNecks(const VoxelGrid& voxels, const CellParameters& parameters, std::size_t storey,
                   const StoreyPlan& plan, RoomSeeds& seeds) {
  constexpr std::size_t kMost = 3;
  const std::vector<WideNeck> necks = wideNecks(voxels, parameters, plan);
  for (std::size_t i = 0; i < std::min(kMost, necks.size()); ++i) {
    seeds.log.push_back(fmt::format(
        "storey {}: a room narrows to {:.1f} m at ({:.1f}, {:.1f}) and stays one; "
        "--merge-ratio {:.2f} parts it there",
        storey + 1, necks[i].width, necks[i].at.x, necks[i].at.y, necks[i].least_ratio));
  }
}

/// Where a roofless model's rooms end.
int highestCeiling(const StoreyPlan& plan) {
  int highest = 0;
  for (const PlanBasin& use : plan.uses) {
    if (use.use == PlanBasin::Use::kRoom) highest = std::max(highest, int(use.ceiling));
  }
  return highest;
}

}  // namespace

RoomSeeds seedRooms(const VoxelGrid& voxels, const std::vector<StoreyBand>& storeys,
                    const CellParameters& parameters) {
  RoomSeeds seeds;
  seeds.storeys = {0};
  seeds.ranges = {{0, voxels.size.y}};
  seeds.widths = {std::numeric_limits<float>::infinity()};
  seeds.owner.assign(voxels.bits.size(), kNobody);
  Rooms rooms;
  for (const StoreyBand& band : storeys)
    rooms.plans.push_back(planStorey(voxels, band, parameters));
  const bool roofless = isRoofless(voxels, rooms.plans);
  if (roofless) seeds.log.push_back("no roof: rooms end at the top of their walls");
  for (std::size_t s = 0; s < storeys.size(); ++s) {
    const int porches = classifyBasins(voxels, parameters, roofless, rooms.plans[s]);
    if (porches > 0) {
      seeds.log.push_back("storey " + std::to_string(s + 1) + ": " + std::to_string(porches) +
                          " porches belong to the exterior");
    }
    tellSmallRooms(voxels, parameters, s, rooms.plans[s], seeds);
    tellWideNecks(voxels, parameters, s, rooms.plans[s], seeds);
    labelStorey(voxels.voxel, s, rooms, seeds);
    seedStorey(voxels, rooms, s, seeds);
  }
  seedSky(voxels, roofless ? highestCeiling(rooms.plans.back()) : 0, seeds);
  return seeds;
}

}  // namespace enfilade
