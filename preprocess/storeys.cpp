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

/// Floor voxels with headroom at each height.
struct FloorHistogram {
  std::vector<double> roofed, open;
};

FloorHistogram countFloors(const VoxelGrid& voxels) {
  const int height = voxels.size.y;
  const int head_room = static_cast<int>(std::ceil(kHeadRoom / voxels.voxel));
  FloorHistogram floors{std::vector<double>(static_cast<std::size_t>(height)), {}};
  floors.open = floors.roofed;
  for (int x = 0; x < voxels.size.x; ++x) {
    for (int z = 0; z < voxels.size.z; ++z) {
      const std::uint8_t* column = &voxels.bits[voxels.index(x, 0, z)];
      int above = -1;  // the last solid voxel on the way down
      for (int y = height - 1; y >= 0; --y) {
        if (!(column[y] & kVoxelSolid)) continue;
        auto& histogram = above < 0 ? floors.open : floors.roofed;
        if ((above < 0 ? height : above) - y > head_room) {
          histogram[static_cast<std::size_t>(y)] += 1;
        }
        above = y;
      }
    }
  }
  return floors;
}

double sum(const std::vector<double>& values) {
  double total = 0;
  for (const double v : values) total += v;
  return total;
}

/// Heights of peaks, the largest first, none nearer than `apart` to a larger one.
std::vector<int> peaks(const std::vector<double>& histogram, int apart, double least) {
  const int n = static_cast<int>(histogram.size());
  const auto at = [&](int y) { return y < 0 || y >= n ? 0.0 : histogram[std::size_t(y)]; };
  std::vector<std::pair<double, int>> candidates;
  for (int y = 0; y < n; ++y) {
    const double area = at(y - 1) + at(y) + at(y + 1);
    if (at(y) > 0) candidates.push_back({-area - 1e-3 * at(y), y});
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
  FloorHistogram floors = countFloors(voxels);
  const double roofed = sum(floors.roofed), open = sum(floors.open);
  if (roofed < kRooflessShare * (roofed + open)) {
    for (std::size_t y = 0; y < floors.open.size(); ++y) floors.roofed[y] += floors.open[y];
  }
  const double voxel_area = static_cast<double>(voxels.voxel) * static_cast<double>(voxels.voxel);
  std::vector<int> heights =
      peaks(floors.roofed, static_cast<int>(std::lround(kLeastHeight / voxels.voxel)),
            kLeastArea / voxel_area);
  if (heights.empty()) heights = peaks(floors.roofed, voxels.size.y, 0.0);
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
