#include "render/occlusion_grid.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

/// The value over the window of something linear in pixels: dot(v, (x, y, 1)).
using Linear = glm::dvec3;

/// The least of `v` over the square whose corner with the least x and y is at the origin.
double leastInSquare(const Linear& v) {
  return v.z + OcclusionGrid::kSide * (std::min(v.x, 0.0) + std::min(v.y, 0.0));
}

/// Narrows low…high (squares) to where `v` ≥ 0 along x, `v` being taken at the row's start and
/// rising by `step` a square.
void narrow(double at_start, double step, double& low, double& high) {
  if (step > 0) {
    low = std::max(low, std::ceil(-at_start / step));
  } else if (step < 0) {
    high = std::min(high, std::floor(at_start / -step));
  } else if (at_start < 0) {
    high = low - 1;
  }
}

}  // namespace

void OcclusionGrid::start(int width, int height) {
  columns_ = (width + kSide - 1) / kSide;
  rows_ = (height + kSide - 1) / kSide;
  depth_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0.0f);
}

void OcclusionGrid::add(const Corners& c, const Limits& limits, int first, int last) noexcept {
  // Olano & Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997: the edges, and
  // 1 / w, are linear in pixels, whether or not a corner is behind the eye.
  std::array<Linear, 5> inside = {glm::cross(c[1], c[2]), glm::cross(c[2], c[0]),
                                  glm::cross(c[0], c[1])};
  const double area = glm::dot(c[0], inside[0]);
  if (area == 0) return;
  const Linear depth = (inside[0] + inside[1] + inside[2]) / area;
  for (std::size_t edge = 0; edge < 3; ++edge) {
    inside[edge] *= area > 0 ? 1.0 : -1.0;
    inside[edge].z -= limits.slack * (std::abs(inside[edge].x) + std::abs(inside[edge].y));
  }
  inside[3] = depth;
  inside[4] = Linear(0, 0, limits.nearest) - depth;
  const double moved = limits.slack * (std::abs(depth.x) + std::abs(depth.y));
  const Linear drawn = limits.factor * depth - Linear(0, 0, limits.less + moved);
  for (int row = first / kSide; row <= last / kSide; ++row) {
    double low = 0;
    double high = columns_ - 1;
    for (const Linear& v : inside) {
      narrow(leastInSquare(v) + v.y * kSide * row, v.x * kSide, low, high);
    }
    if (!(low <= high)) continue;
    const double at_start = leastInSquare(drawn) + drawn.y * kSide * row;
    float* squares = &depth_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)];
    for (int column = static_cast<int>(low); column <= high; ++column) {
      const double here = at_start + drawn.x * kSide * column;
      squares[column] = std::max(squares[column], static_cast<float>(here));
    }
  }
}

bool OcclusionGrid::hides(int x0, int y0, int x1, int y1, float nearest) const noexcept {
  for (int row = y0 / kSide; row <= y1 / kSide; ++row) {
    const float* squares =
        &depth_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_)];
    for (int column = x0 / kSide; column <= x1 / kSide; ++column) {
      if (squares[column] <= nearest) return false;
    }
  }
  return true;
}

}  // namespace enfilade
