#include "portals/cell_grid.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "scene/error.h"

namespace enfilade {

namespace {

std::size_t columnCount(const glm::ivec3& size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.z);
}

void check(bool good, const char* reason) {
  if (!good) throw Error(ErrorKind::kBadInput, "cell grid", reason);
}

void checkFrame(const glm::vec3& origin, float voxel, const glm::ivec3& size) {
  check(std::isfinite(origin.x) && std::isfinite(origin.y) && std::isfinite(origin.z),
        "the origin is not a finite number");
  check(std::isfinite(voxel) && voxel > 0, "the voxel edge is not a positive number");
  check(std::min({size.x, size.y, size.z}) >= 1 && std::max({size.x, size.y, size.z}) <= 65535,
        "a size is not in 1…65535");
}

/// The voxel coordinate of a scaled offset, kept in the range of int (NaN goes to the least).
int voxelCoordinate(float scaled) noexcept {
  constexpr float kFar = 1e9f;
  const float lower = scaled >= -kFar ? std::floor(scaled) : -kFar;
  return static_cast<int>(std::min(lower, kFar));
}

}  // namespace

CellGrid::CellGrid(const glm::vec3& origin, float voxel, const glm::ivec3& size,
                   std::span<const Label> labels)
    : origin_(origin), voxel_(voxel), size_(size) {
  checkFrame(origin, voxel, size);
  const auto height = static_cast<std::size_t>(size.y);
  assert(labels.size() == columnCount(size) * height);
  first_.reserve(columnCount(size) + 1);
  first_.push_back(0);
  for (std::size_t column = 0; column < columnCount(size); ++column) {
    const auto voxels = labels.subspan(column * height, height);
    for (std::size_t y = 1; y <= height; ++y) {
      if (y == height || voxels[y] != voxels[y - 1]) {
        runs_.push_back({static_cast<std::uint16_t>(y), voxels[y - 1]});
      }
    }
    check(runs_.size() <= 0xffffffffu, "too many runs");
    first_.push_back(static_cast<std::uint32_t>(runs_.size()));
  }
}

CellGrid::CellGrid(const glm::vec3& origin, float voxel, const glm::ivec3& size,
                   std::vector<std::uint32_t> first, std::vector<Run> runs)
    : origin_(origin),
      voxel_(voxel),
      size_(size),
      first_(std::move(first)),
      runs_(std::move(runs)) {
  checkFrame(origin, voxel, size);
  check(first_.size() == columnCount(size) + 1, "the number of columns is not that of its size");
  check(first_.front() == 0 && first_.back() == runs_.size(), "the columns do not span the runs");
  for (std::size_t column = 0; column + 1 < first_.size(); ++column) {
    check(first_[column] < first_[column + 1] && first_[column + 1] <= runs_.size(),
          "a column has no runs");
    int begin = 0;
    for (std::size_t i = first_[column]; i < first_[column + 1]; ++i) {
      check(runs_[i].end_y > begin, "the runs of a column do not ascend");
      begin = runs_[i].end_y;
    }
    check(begin == size.y, "the runs of a column do not fill it");
  }
}

std::span<const CellGrid::Run> CellGrid::column(int x, int z) const noexcept {
  assert(x >= 0 && x < size_.x && z >= 0 && z < size_.z);
  const std::size_t i =
      static_cast<std::size_t>(x) * static_cast<std::size_t>(size_.z) + static_cast<std::size_t>(z);
  return std::span(runs_).subspan(first_[i], first_[i + 1] - first_[i]);
}

glm::ivec3 CellGrid::voxelOf(const glm::vec3& p) const noexcept {
  const glm::vec3 scaled = (p - origin_) / voxel_;
  return {voxelCoordinate(scaled.x), voxelCoordinate(scaled.y), voxelCoordinate(scaled.z)};
}

glm::vec3 CellGrid::centerOf(const glm::ivec3& v) const noexcept {
  return origin_ + (glm::vec3(v) + 0.5f) * voxel_;
}

CellGrid::Label CellGrid::labelAt(const glm::ivec3& v) const noexcept {
  if (glm::any(glm::lessThan(v, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(v, size_))) {
    return kExterior;
  }
  const auto runs = column(v.x, v.z);
  return std::upper_bound(runs.begin(), runs.end(), v.y,
                          [](int y, const Run& run) { return y < run.end_y; })
      ->label;
}

}  // namespace enfilade
