#include "app/plan_slice.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace enfilade {

namespace {

/// The squares that hold a label: columns and rows [low, high).
struct SquareBounds {
  glm::ivec2 low{0}, high{0};
  int squares = 0;
};

SquareBounds boundsOf(const PlanSlice& slice, CellGrid::Label label) {
  SquareBounds bounds{{slice.columns, slice.rows}, {0, 0}, 0};
  for (int row = 0; row < slice.rows; ++row) {
    for (int column = 0; column < slice.columns; ++column) {
      if (slice.at(column, row) != label) continue;
      bounds.low = glm::min(bounds.low, glm::ivec2(column, row));
      bounds.high = glm::max(bounds.high, glm::ivec2(column + 1, row + 1));
      ++bounds.squares;
    }
  }
  return bounds;
}

// Directions in which an outline walks, the label on its right: east, south, west, north.
constexpr std::array<glm::ivec2, 4> kSteps = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

/// For every corner, the directions in which an outline leaves it, as bits.
class CornerSteps {
 public:
  CornerSteps(const PlanSlice& slice, CellGrid::Label label, const SquareBounds& bounds)
      : low_(bounds.low), width_(bounds.high.x - bounds.low.x + 1) {
    const int height = bounds.high.y - bounds.low.y + 1;
    bits_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height));
    const auto owned = [&](int c, int r) {
      return c >= 0 && r >= 0 && c < slice.columns && r < slice.rows && slice.at(c, r) == label;
    };
    for (int r = bounds.low.y; r < bounds.high.y; ++r) {
      for (int c = bounds.low.x; c < bounds.high.x; ++c) {
        if (!owned(c, r)) continue;
        if (!owned(c, r - 1)) at({c, r}) |= 1;
        if (!owned(c + 1, r)) at({c + 1, r}) |= 2;
        if (!owned(c, r + 1)) at({c + 1, r + 1}) |= 4;
        if (!owned(c - 1, r)) at({c, r + 1}) |= 8;
      }
    }
  }

  std::uint8_t& at(const glm::ivec2& corner) {
    return bits_[static_cast<std::size_t>(corner.y - low_.y) * static_cast<std::size_t>(width_) +
                 static_cast<std::size_t>(corner.x - low_.x)];
  }

 private:
  glm::ivec2 low_;
  int width_;
  std::vector<std::uint8_t> bits_;
};

/// Walks from `start` until it is back, and takes every step with it.
std::vector<glm::ivec2> walkLoop(CornerSteps& steps, const glm::ivec2& start) {
  std::vector<glm::ivec2> loop;
  glm::ivec2 corner = start;
  int before = -1;
  do {
    std::uint8_t& bits = steps.at(corner);
    int direction = 0;
    while (!(bits & (1 << direction))) ++direction;
    bits = static_cast<std::uint8_t>(bits & ~(1 << direction));
    if (direction != before) loop.push_back(corner);
    before = direction;
    corner += kSteps[static_cast<std::size_t>(direction)];
  } while (corner != start);
  return loop;
}

}  // namespace

PlanSlice sliceHouse(const CellGraph& graph, const CellGrid& grid, float y) {
  PlanSlice slice;
  slice.y = y;
  slice.origin = {grid.origin().x, grid.origin().z};
  slice.voxel = grid.voxel();
  slice.columns = grid.size().x;
  slice.rows = grid.size().z;
  slice.owner.reserve(static_cast<std::size_t>(slice.columns) *
                      static_cast<std::size_t>(slice.rows));
  const int layer = grid.voxelOf({grid.origin().x, y, grid.origin().z}).y;
  for (int z = 0; z < slice.rows; ++z) {
    for (int x = 0; x < slice.columns; ++x) {
      const glm::ivec3 voxel(x, layer, z);
      CellGrid::Label label = grid.labelAt(voxel);
      if (label == CellGrid::kCutVoxel) {
        label = static_cast<CellGrid::Label>(locate(graph, grid, grid.centerOf(voxel)).cell);
      }
      slice.owner.push_back(label);
    }
  }
  return slice;
}

std::vector<std::vector<glm::ivec2>> traceOutline(const PlanSlice& slice, CellGrid::Label label) {
  std::vector<std::vector<glm::ivec2>> loops;
  const SquareBounds bounds = boundsOf(slice, label);
  if (bounds.squares == 0) return loops;
  CornerSteps steps(slice, label, bounds);
  for (int row = bounds.low.y; row <= bounds.high.y; ++row) {
    for (int column = bounds.low.x; column <= bounds.high.x; ++column) {
      while (steps.at({column, row}) != 0) loops.push_back(walkLoop(steps, {column, row}));
    }
  }
  return loops;
}

LabelPlace placeLabel(const PlanSlice& slice, CellGrid::Label label) {
  const SquareBounds bounds = boundsOf(slice, label);
  LabelPlace best;
  best.squares = bounds.squares;
  float best_room = 0;
  const auto owned = [&](int c, int r) {
    return r >= 0 && r < slice.rows && slice.at(c, r) == label;
  };
  for (int row = bounds.low.y; row < bounds.high.y; ++row) {
    for (int start = bounds.low.x; start < bounds.high.x;) {
      int end = start;
      while (end < bounds.high.x && owned(end, row)) ++end;
      if (end == start) {
        ++start;
        continue;
      }
      const int middle = (start + end) / 2;
      int up = 0, down = 0;
      while (owned(middle, row - up - 1)) ++up;
      while (owned(middle, row + down + 1)) ++down;
      const auto width = static_cast<float>(end - start);
      const auto height = static_cast<float>(2 * std::min(up, down) + 1);
      // A name is some four times as wide as it is high.
      const float room = std::min(width, 4.0f * height) + 0.01f * height;
      if (room > best_room) {
        best_room = room;
        best.center = {0.5f * static_cast<float>(start + end), static_cast<float>(row) + 0.5f};
        best.width = width;
        best.height = height;
      }
      start = end;
    }
  }
  return best;
}

}  // namespace enfilade
