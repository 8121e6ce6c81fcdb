#include "preprocess/storey_plan.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kSkyShare = 0.5f;     // more of a basin open to the sky: exterior
constexpr float kPorchShare = 0.3f;   // more of its outline open to the exterior: a porch
constexpr float kWalledShare = 0.7f;  // of its outline: enclosed, though there be no roof
constexpr float kIsland = 2.0f;      // [m] what stands free is no wall if it is no longer than this
constexpr float kNiche = 0.45f;      // [m²] smaller basins are not worth a word
constexpr float kClearNeck = 0.85f;  // of the narrower part's width: wider ones are no necks
constexpr float kHollow = 0.3f;      // [m] nor narrower ones
constexpr float kGarden = 50.0f;  // [m²] what is larger counts as this much: a garden has walls too
constexpr float kRoofless = 3.0f;  // times more enclosed plan without a roof than with one

constexpr std::array<std::pair<int, int>, 4> kSides{{{-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

/// Calls visit(basin, here, there) for the outline of every basin.
template <typename Visit>
void forEachEdge(const StoreyPlan& plan, const Visit& visit) {
  const StoreySlice& slice = plan.slice;
  for (int x = 0; x < slice.size_x; ++x) {
    for (int z = 0; z < slice.size_z; ++z) {
      const std::size_t here = slice.index(x, z);
      const std::int32_t basin = plan.basins.of_pixel[here];
      if (basin == Basins::kNone) continue;
      for (const auto& [dx, dz] : kSides) {
        const int ox = x + dx, oz = z + dz;
        if (ox < 0 || oz < 0 || ox >= slice.size_x || oz >= slice.size_z) continue;
        const std::size_t there = slice.index(ox, oz);
        if (plan.basins.of_pixel[there] != basin) visit(std::size_t(basin), here, there);
      }
    }
  }
}

void measureBasins(StoreyPlan& plan) {
  const StoreySlice& slice = plan.slice;
  plan.uses.assign(plan.basins.peak.size(), {});
  for (int x = 0; x < slice.size_x; ++x) {
    for (int z = 0; z < slice.size_z; ++z) {
      const std::size_t here = slice.index(x, z);
      const std::int32_t basin = plan.basins.of_pixel[here];
      if (basin == Basins::kNone) continue;
      PlanBasin& use = plan.uses[std::size_t(basin)];
      ++use.area;
      use.open_to_sky += slice.open_to_sky[here];
      use.at_border |= x == 0 || z == 0 || x + 1 == slice.size_x || z + 1 == slice.size_z;
    }
  }
  forEachEdge(plan, [&](std::size_t basin, std::size_t, std::size_t there) {
    ++plan.uses[basin].border;
    if (slice.kind[there] != ColumnKind::kFree) ++plan.uses[basin].walled;
    if (slice.kind[there] != ColumnKind::kWall) ++plan.uses[basin].openings;
  });
}

bool underSky(const PlanBasin& use) { return float(use.open_to_sky) > kSkyShare * float(use.area); }

bool enclosed(const PlanBasin& use) {
  return !use.at_border && float(use.walled) >= kWalledShare * float(use.border);
}

/// One past the solid run that stands in a wall column at the slice.
std::int32_t wallTop(const VoxelGrid& voxels, const StoreySlice& slice, std::size_t column) {
  const auto size_y = static_cast<std::size_t>(voxels.size.y);
  std::int32_t y = slice.low[column];
  while (y < voxels.size.y && (voxels.bits[column * size_y + std::size_t(y)] & kVoxelSolid)) ++y;
  return y;
}

std::int32_t median(std::vector<std::int32_t>& values, std::int32_t otherwise) {
  if (values.empty()) return otherwise;
  const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Ceilings from the columns that have one, or else from the tops of the walls around.
void setCeilings(const VoxelGrid& voxels, StoreyPlan& plan) {
  const StoreySlice& slice = plan.slice;
  std::vector<std::vector<std::int32_t>> highs(plan.uses.size()), tops(plan.uses.size());
  for (std::size_t i = 0; i < slice.kind.size(); ++i) {
    const std::int32_t basin = plan.basins.of_pixel[i];
    if (basin != Basins::kNone && !slice.open_to_sky[i]) {
      highs[std::size_t(basin)].push_back(slice.high[i]);
    }
  }
  forEachEdge(plan, [&](std::size_t basin, std::size_t, std::size_t there) {
    if (slice.kind[there] == ColumnKind::kWall && !plan.uses[basin].at_border) {
      tops[basin].push_back(wallTop(voxels, slice, there));
    }
  });
  for (std::size_t b = 0; b < plan.uses.size(); ++b) {
    auto& values = underSky(plan.uses[b]) ? tops[b] : highs[b];
    plan.uses[b].ceiling = median(values, voxels.size.y);
  }
}

/// Gives porches to the exterior until none is left.
int openPorches(StoreyPlan& plan) {
  const auto is = [&](std::size_t basin, PlanBasin::Use use) {
    return plan.uses[basin].use == use;
  };
  int porches = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (PlanBasin& use : plan.uses) use.to_exterior = 0;
    forEachEdge(plan, [&](std::size_t basin, std::size_t, std::size_t there) {
      const std::int32_t other = plan.basins.of_pixel[there];
      if (other != Basins::kNone && is(std::size_t(other), PlanBasin::Use::kOutside)) {
        ++plan.uses[basin].to_exterior;
      }
    });
    for (PlanBasin& use : plan.uses) {
      if (use.use != PlanBasin::Use::kRoom) continue;
      if (float(use.to_exterior) > kPorchShare * float(use.border)) {
        use.use = PlanBasin::Use::kOutside;
        changed = true;
        ++porches;
      }
    }
  }
  return porches;
}

/// How many pixels of the box low…high an island in it closes in.
int enclosedPixels(const std::vector<glm::ivec2>& island, const glm::ivec2& low,
                   const glm::ivec2& high) {
  const glm::ivec2 size = high - low + 3;  // a free rim about it
  std::vector<std::uint8_t> taken(std::size_t(size.x) * std::size_t(size.y), 0);
  const auto at = [&](const glm::ivec2& p) -> std::uint8_t& {
    return taken[std::size_t(p.x) * std::size_t(size.y) + std::size_t(p.y)];
  };
  for (const glm::ivec2& p : island) at(p - low + 1) = 1;
  std::vector<glm::ivec2> stack{{0, 0}};
  at({0, 0}) = 1;
  int left = size.x * size.y - static_cast<int>(island.size());
  while (!stack.empty()) {
    const glm::ivec2 p = stack.back();
    stack.pop_back();
    --left;
    for (const auto& [dx, dz] : kSides) {
      const glm::ivec2 q = p + glm::ivec2(dx, dz);
      if (q.x < 0 || q.y < 0 || q.x >= size.x || q.y >= size.y || at(q)) continue;
      at(q) = 1;
      stack.push_back(q);
    }
  }
  return left;
}

/// Makes `inside` of what stands free, is no larger than furniture, columns or sculpture, and holds
/// no room: it narrows none.
void clearIslands(const StoreySlice& slice, int most_pixels, int least_room,
                  std::vector<std::uint8_t>& inside) {
  std::vector<std::uint8_t> seen = inside;
  std::vector<glm::ivec2> island;
  for (int x = 0; x < slice.size_x; ++x) {
    for (int z = 0; z < slice.size_z; ++z) {
      if (seen[slice.index(x, z)]) continue;
      seen[slice.index(x, z)] = 1;
      island.assign(1, {x, z});
      glm::ivec2 low(x, z), high(x, z);
      for (std::size_t next = 0; next < island.size(); ++next) {
        const glm::ivec2 p = island[next];
        low = glm::min(low, p);
        high = glm::max(high, p);
        for (int n = 0; n < 9; ++n) {
          const glm::ivec2 q = p + glm::ivec2(n / 3 - 1, n % 3 - 1);
          if (q.x < 0 || q.y < 0 || q.x >= slice.size_x || q.y >= slice.size_z) continue;
          const std::size_t there = slice.index(q.x, q.y);
          if (seen[there]) continue;
          seen[there] = 1;
          island.push_back(q);
        }
      }
      const glm::ivec2 size = high - low + 1;
      if (std::max(size.x, size.y) > most_pixels ||
          enclosedPixels(island, low, high) >= least_room) {
        continue;
      }
      for (const glm::ivec2& p : island) inside[slice.index(p.x, p.y)] = 1;
    }
  }
}

}  // namespace

StoreyPlan planStorey(const VoxelGrid& voxels, const StoreyBand& band,
                      const CellParameters& parameters) {
  StoreyPlan plan{band, sliceStorey(voxels, band, parameters), {}, {}};
  std::vector<std::uint8_t> inside(plan.slice.kind.size());
  for (std::size_t i = 0; i < inside.size(); ++i) {
    inside[i] = plan.slice.kind[i] == ColumnKind::kFree;
  }
  const float pixel_area = voxels.voxel * voxels.voxel;
  clearIslands(plan.slice, int(kIsland / voxels.voxel),
               int(std::max(parameters.smallest_room, kNiche) / pixel_area), inside);
  const int size_x = plan.slice.size_x, size_z = plan.slice.size_z;
  plan.basins =
      watershed(squaredDistance(inside, size_x, size_z), size_x, size_z, parameters.merge_ratio);
  measureBasins(plan);
  return plan;
}

bool isRoofless(const VoxelGrid& voxels, const std::vector<StoreyPlan>& plans) {
  const float pixel_area = voxels.voxel * voxels.voxel;
  float with = 0, without = 0;
  for (const StoreyPlan& plan : plans) {
    for (const PlanBasin& use : plan.uses) {
      if (!enclosed(use)) continue;
      (underSky(use) ? without : with) += std::min(float(use.area) * pixel_area, kGarden);
    }
  }
  return without > kRoofless * with;
}

std::vector<SmallRoom> smallRooms(const VoxelGrid& voxels, const StoreyPlan& plan) {
  const float pixel_area = voxels.voxel * voxels.voxel;
  std::vector<glm::vec2> sums(plan.uses.size(), glm::vec2(0));
  for (int x = 0; x < plan.slice.size_x; ++x) {
    for (int z = 0; z < plan.slice.size_z; ++z) {
      const std::int32_t basin = plan.basins.of_pixel[plan.slice.index(x, z)];
      if (basin == Basins::kNone) continue;
      const glm::vec3 center = voxels.centerOf({x, 0, z});
      sums[std::size_t(basin)] += glm::vec2(center.x, center.z);
    }
  }
  std::vector<SmallRoom> rooms;
  for (std::size_t b = 0; b < plan.uses.size(); ++b) {
    const PlanBasin& use = plan.uses[b];
    const float area = float(use.area) * pixel_area;
    const float width = 2 * plan.basins.peak[b] * voxels.voxel;
    if (use.use != PlanBasin::Use::kTooSmall || area < kNiche || width < kHollow ||
        use.openings == 0 || float(use.walled) < 0.5f * float(use.border)) {
      continue;
    }
    rooms.push_back({sums[b] / float(use.area), area, width});
  }
  std::stable_sort(rooms.begin(), rooms.end(),
                   [](const SmallRoom& a, const SmallRoom& b) { return a.area > b.area; });
  return rooms;
}

std::vector<WideNeck> wideNecks(const VoxelGrid& voxels, const CellParameters& parameters,
                                const StoreyPlan& plan) {
  const float pixel_area = voxels.voxel * voxels.voxel;
  std::vector<WideNeck> necks;
  for (const Neck& neck : plan.basins.necks) {
    const auto pixel = static_cast<std::size_t>(neck.pixel);
    const std::int32_t basin = plan.basins.of_pixel[pixel];
    const float area = float(neck.area) * pixel_area;
    if (plan.uses[std::size_t(basin)].use != PlanBasin::Use::kRoom || neck.ratio > kClearNeck ||
        area < std::max(parameters.smallest_room, kNiche)) {
      continue;
    }
    const auto size_z = static_cast<std::size_t>(plan.slice.size_z);
    const glm::vec3 center = voxels.centerOf({int(pixel / size_z), 0, int(pixel % size_z)});
    necks.push_back({{center.x, center.z},
                     2 * neck.half_width * voxels.voxel,
                     area,
                     std::ceil(neck.ratio * 100 + 0.1f) / 100});
  }
  std::stable_sort(necks.begin(), necks.end(), [](const WideNeck& a, const WideNeck& b) {
    return a.least_ratio < b.least_ratio;
  });
  return necks;
}

int classifyBasins(const VoxelGrid& voxels, const CellParameters& parameters, bool roofless,
                   StoreyPlan& plan) {
  const float pixel_area = voxels.voxel * voxels.voxel;
  for (std::size_t b = 0; b < plan.uses.size(); ++b) {
    PlanBasin& use = plan.uses[b];
    if (use.at_border || (underSky(use) && !(roofless && enclosed(use)))) {
      use.use = PlanBasin::Use::kOutside;
    } else if (float(use.area) * pixel_area < parameters.smallest_room ||
               plan.basins.peak[b] * voxels.voxel < 0.5f * parameters.smallest_door) {
      use.use = PlanBasin::Use::kTooSmall;
    }
  }
  setCeilings(voxels, plan);
  return openPorches(plan);
}

}  // namespace enfilade
