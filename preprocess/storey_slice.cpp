#include "preprocess/storey_slice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace enfilade {

namespace {

using Heights = std::vector<std::int32_t>;

constexpr float kSill = 0.3f;  // [m] above the floor: under a lintel, a window's

constexpr std::int32_t kUnknown = std::numeric_limits<std::int32_t>::min();

/// The offsets of a disc of `radius` [voxels], so that turned buildings fare alike.
std::vector<std::pair<int, int>> disc(float radius) {
  std::vector<std::pair<int, int>> offsets;
  const int r = static_cast<int>(std::ceil(radius));
  for (int dx = -r; dx <= r; ++dx) {
    for (int dz = -r; dz <= r; ++dz) {
      if (static_cast<float>(dx * dx + dz * dz) <= radius * radius) offsets.push_back({dx, dz});
    }
  }
  return offsets;
}

/// The greatest (or with sign −1 the least) of `values` over the disc around each known column.
Heights extreme(const StoreySlice& slice, const Heights& values,
                const std::vector<std::pair<int, int>>& offsets, int sign) {
  Heights result(values.size(), kUnknown);
  for (int x = 0; x < slice.size_x; ++x) {
    for (int z = 0; z < slice.size_z; ++z) {
      const std::size_t here = slice.index(x, z);
      if (values[here] == kUnknown) continue;
      std::int32_t best = values[here];
      for (const auto& [dx, dz] : offsets) {
        const int ox = x + dx, oz = z + dz;
        if (ox < 0 || oz < 0 || ox >= slice.size_x || oz >= slice.size_z) continue;
        const std::int32_t other = values[slice.index(ox, oz)];
        if (other != kUnknown && sign * (other - best) > 0) best = other;
      }
      result[here] = best;
    }
  }
  return result;
}

/// Fills one column; returns the top of its free run, glass or not, kUnknown for a wall.
std::int32_t sliceColumn(const VoxelGrid& voxels, int x, int z, int at, StoreySlice& slice) {
  const std::uint8_t* column = &voxels.bits[voxels.index(x, 0, z)];
  const std::size_t here = slice.index(x, z);
  slice.low[here] = slice.high[here] = at;
  if (column[at] & kVoxelSolid) return kUnknown;
  int low = at, high = at, top = at;
  while (low > 0 && !(column[low - 1] & kVoxelSolid)) --low;
  while (top < voxels.size.y && !(column[top] & kVoxelSolid)) ++top;
  while (high < top && (high == at || !(column[high] & kVoxelGlass))) ++high;
  slice.low[here] = low;
  slice.high[here] = high;
  slice.open_to_sky[here] = high == voxels.size.y;
  const bool named = column[at] & (kVoxelDoor | kVoxelGlass);
  slice.kind[here] = named ? ColumnKind::kSeparator : ColumnKind::kFree;
  return top;
}

}  // namespace

StoreySlice sliceStorey(const VoxelGrid& voxels, const StoreyBand& storey,
                        const CellParameters& parameters) {
  StoreySlice slice{voxels.size.x, voxels.size.z, {}, {}, {}, {}};
  const std::size_t count = slice.index(voxels.size.x - 1, voxels.size.z - 1) + 1;
  slice.kind.assign(count, ColumnKind::kWall);
  slice.low.assign(count, 0);
  slice.high.assign(count, 0);
  slice.open_to_sky.assign(count, 0);
  const int at =
      std::min(storey.floor + static_cast<int>(std::lround(parameters.slice_height / voxels.voxel)),
               voxels.size.y - 1);
  Heights top(count, kUnknown);
  for (int x = 0; x < slice.size_x; ++x) {
    for (int z = 0; z < slice.size_z; ++z) {
      top[slice.index(x, z)] = sliceColumn(voxels, x, z, at, slice);
    }
  }
  const auto offsets = disc(parameters.lintel_radius / voxels.voxel);
  const Heights closed = extreme(slice, extreme(slice, top, offsets, 1), offsets, -1);
  const int head =
      storey.floor + 1 + static_cast<int>(std::lround(parameters.lintel_head / voxels.voxel));
  const int sill = storey.floor + 1 + static_cast<int>(std::lround(kSill / voxels.voxel));
  for (std::size_t i = 0; i < count; ++i) {
    if (top[i] == kUnknown || closed[i] <= top[i]) continue;
    if (top[i] <= head || slice.low[i] >= sill) slice.kind[i] = ColumnKind::kSeparator;
  }
  return slice;
}

}  // namespace enfilade
