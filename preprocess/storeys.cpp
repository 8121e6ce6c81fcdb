#include "preprocess/storeys.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr float kHeadRoom = 1.8f;        // [m] free above a floor
constexpr float kLeastHeight = 2.0f;     // [m] between two floors
constexpr float kLeastArea = 4.0f;       // [m²] of a storey's floor
constexpr float kLeastShare = 0.05f;     // of the largest storey's floor
constexpr float kRooflessShare = 0.25f;  // less of the floors roofed over: a model without a roof
constexpr float kClimb = 0.3f;           // [m] from one column of the ground to the next

/// Floor voxels with headroom at each height: under something, under the sky but shut in by walls,
/// and outdoors.
struct FloorHistogram {
  std::vector<double> roofed, walled, outdoors;
};

/// The highest solid voxel of each column, −1 without one; index x · size.z + z.
std::vector<int> columnTops(const VoxelGrid& voxels) {
  std::vector<int> tops;
  for (int x = 0; x < voxels.size.x; ++x) {
    for (int z = 0; z < voxels.size.z; ++z) {
      const std::uint8_t* column = &voxels.bits[voxels.index(x, 0, z)];
      int y = voxels.size.y - 1;
      while (y >= 0 && !(column[y] & kVoxelSolid)) --y;
      tops.push_back(y);
    }
  }
  return tops;
}

/// The columns that one comes to from beyond the model without climbing: the ground around a
/// house.
std::vector<std::uint8_t> groundAround(const VoxelGrid& voxels, const std::vector<int>& tops) {
  const int climb = static_cast<int>(std::lround(kClimb / voxels.voxel));
  const glm::ivec2 size(voxels.size.x, voxels.size.z);
  std::vector<std::uint8_t> reached(tops.size(), 0);
  std::vector<glm::ivec2> waiting;
  const auto reach = [&](const glm::ivec2& p) {
    std::uint8_t& there = reached[std::size_t(p.x * size.y + p.y)];
    if (there) return;
    there = 1;
    waiting.push_back(p);
  };
  for (int x = 0; x < size.x; ++x) reach({x, 0}), reach({x, size.y - 1});
  for (int z = 0; z < size.y; ++z) reach({0, z}), reach({size.x - 1, z});
  while (!waiting.empty()) {
    const glm::ivec2 p = waiting.back();
    waiting.pop_back();
    const int top = tops[std::size_t(p.x * size.y + p.y)];
    for (const glm::ivec2 side : {glm::ivec2(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
      const glm::ivec2 to = p + side;
      if (to.x < 0 || to.y < 0 || to.x >= size.x || to.y >= size.y) continue;
      const int other = tops[std::size_t(to.x * size.y + to.y)];
      if (top < 0 || std::abs(other - top) <= climb) reach(to);
    }
  }
  return reached;
}

FloorHistogram countFloors(const VoxelGrid& voxels) {
  const int height = voxels.size.y;
  const int head_room = static_cast<int>(std::ceil(kHeadRoom / voxels.voxel));
  const std::vector<double> none(static_cast<std::size_t>(height));
  FloorHistogram floors{none, none, none};
  const auto tops = columnTops(voxels);
  const auto outdoors = groundAround(voxels, tops);
  for (std::size_t i = 0; i < tops.size(); ++i) {
    const int x = static_cast<int>(i) / voxels.size.z, z = static_cast<int>(i) % voxels.size.z;
    const std::uint8_t* column = &voxels.bits[voxels.index(x, 0, z)];
    if (tops[i] < 0) continue;
    if (height - tops[i] > head_room)
      (outdoors[i] ? floors.outdoors : floors.walled)[static_cast<std::size_t>(tops[i])] += 1;
    int above = tops[i];  // the last solid voxel on the way down
    for (int y = tops[i] - 1; y >= 0; --y) {
      if (!(column[y] & kVoxelSolid)) continue;
      if (above - y > head_room) floors.roofed[static_cast<std::size_t>(y)] += 1;
      above = y;
    }
  }
  return floors;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double v : values) total += v;
  return total;
}

std::vector<double> added(std::vector<double> a, const std::vector<double>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
  return a;
}

/// Heights of peaks, the largest first, none nearer than `apart` to a larger one.  A peak is the
/// floor itself: what lies a voxel above or below counts with it, but is not taken for it.
std::vector<int> peaks(const std::vector<double>& histogram, int apart, double least) {
  const int n = static_cast<int>(histogram.size());
  const auto at = [&](int y) { return y < 0 || y >= n ? 0.0 : histogram[std::size_t(y)]; };
  std::vector<std::pair<double, int>> candidates;
  for (int y = 0; y < n; ++y) {
    const double area = at(y - 1) + at(y) + at(y + 1);
    if (at(y) > 0 && at(y) >= at(y - 1) && at(y) >= at(y + 1)) candidates.push_back({-area, y});
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<int> found;
  for (const auto& [negative_area, y] : candidates) {
    if (-negative_area < std::max(least, -candidates.front().first * kLeastShare)) break;
    const bool near = std::any_of(found.begin(), found.end(),
                                  [&](int other) { return std::abs(other - y) < apart; });
    if (!near) found.push_back(y);
  }
  return found;
}

}  // namespace

std::vector<StoreyBand> findStoreys(const VoxelGrid& voxels) {
  const FloorHistogram floors = countFloors(voxels);
  const double roofed = sum(floors.roofed), walled = sum(floors.walled);
  std::vector<double> counted = floors.roofed;
  if (roofed < kRooflessShare * (roofed + walled)) counted = added(counted, floors.walled);
  const double voxel_area = static_cast<double>(voxels.voxel) * static_cast<double>(voxels.voxel);
  const int apart = static_cast<int>(std::lround(kLeastHeight / voxels.voxel));
  std::vector<int> heights = peaks(counted, apart, kLeastArea / voxel_area);
  if (heights.empty()) {
    counted = added(added(floors.roofed, floors.walled), floors.outdoors);
    heights = peaks(counted, apart, kLeastArea / voxel_area);
  }
  if (heights.empty()) heights = peaks(counted, voxels.size.y, 0.0);
  if (heights.empty()) heights = {0};
  std::sort(heights.begin(), heights.end());

  std::vector<StoreyBand> storeys;
  for (std::size_t i = 0; i < heights.size(); ++i) {
    storeys.push_back({heights[i], i == 0 ? 0 : heights[i] + 1,
                       i + 1 < heights.size() ? heights[i + 1] + 1 : voxels.size.y});
  }
  return storeys;
}

}  // namespace enfilade
