#include "models/curved_surface.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace enfilade {
namespace {

/// The points and normals of a grid; seams and poles share theirs.
class GridPoints {
 public:
  GridPoints(const CurvedSurface& surface, const SurfaceGrid& grid)
      : surface_(surface), grid_(grid) {
    points_.resize(std::size_t{grid.u + 1} * (grid.v + 1));
    normals_.assign(points_.size(), glm::dvec3(0));
    for (std::uint32_t j = 0; j <= grid.v; ++j)
      for (std::uint32_t i = 0; i <= grid.u; ++i)
        if (owner(i, j) == index(i, j))
          points_[index(i, j)] = surface.at(double(i) / grid.u, double(j) / grid.v);
    for (std::uint32_t j = 0; j < grid.v; ++j)
      for (std::uint32_t i = 0; i < grid.u; ++i) addNormals(i, j);
  }

  const SurfacePoint& point(std::uint32_t i, std::uint32_t j) const { return points_[owner(i, j)]; }
  const glm::dvec3& normal(std::uint32_t i, std::uint32_t j) const { return normals_[owner(i, j)]; }

 private:
  std::size_t index(std::uint32_t i, std::uint32_t j) const {
    return std::size_t{j} * (grid_.u + 1) + i;
  }

  std::size_t owner(std::uint32_t i, std::uint32_t j) const {
    if (surface_.closed_v && j == grid_.v) j = 0;
    if (surface_.closed_u && i == grid_.u) i = 0;
    if ((surface_.pole_low && j == 0) || (surface_.pole_high && j == grid_.v)) i = 0;
    return index(i, j);
  }

  void addNormals(std::uint32_t i, std::uint32_t j) {
    const glm::dvec3 diagonal = point(i + 1, j + 1).position - point(i, j).position;
    const glm::dvec3 other = point(i, j + 1).position - point(i + 1, j).position;
    const glm::dvec3 n = glm::cross(diagonal, other);
    for (const std::size_t corner :
         {owner(i, j), owner(i + 1, j), owner(i + 1, j + 1), owner(i, j + 1)})
      normals_[corner] += n;
  }

  const CurvedSurface& surface_;
  SurfaceGrid grid_;
  std::vector<SurfacePoint> points_;
  std::vector<glm::dvec3> normals_;
};

}  // namespace

SurfaceGrid gridFor(const CurvedSurface& surface, double triangles) {
  const double quads = 0.5 * triangles;
  SurfaceGrid grid;
  grid.u = static_cast<std::uint32_t>(
      std::max(6.0, std::round(std::sqrt(quads * std::max(surface.aspect, 1e-3)))));
  const double poles = 0.5 * ((surface.pole_low ? 1 : 0) + (surface.pole_high ? 1 : 0));
  grid.v = static_cast<std::uint32_t>(std::max(3.0, std::round(quads / grid.u + poles)));
  return grid;
}

std::size_t triangleCount(const CurvedSurface& surface, const SurfaceGrid& grid) {
  const std::size_t poles = (surface.pole_low ? 1u : 0u) + (surface.pole_high ? 1u : 0u);
  return std::size_t{2} * grid.u * grid.v - poles * grid.u;
}

void raiseSurface(const CurvedSurface& surface, const SurfaceGrid& grid, MeshBuilder& mesh) {
  const GridPoints points(surface, grid);
  std::vector<std::uint32_t> below, row(grid.u + 1);
  for (std::uint32_t j = 0; j <= grid.v; ++j) {
    for (std::uint32_t i = 0; i <= grid.u; ++i) {
      const SurfacePoint& p = points.point(i, j);
      const glm::dvec2 uv(double(i) / grid.u, 1 - double(j) / grid.v);
      row[i] = mesh.vertex({p.position, uv * surface.repeats, p.shade}, points.normal(i, j));
    }
    for (std::uint32_t i = 0; j > 0 && i < grid.u; ++i) {
      if (!(surface.pole_low && j == 1)) mesh.triangle(below[i], below[i + 1], row[i + 1]);
      if (!(surface.pole_high && j == grid.v)) mesh.triangle(below[i], row[i + 1], row[i]);
    }
    below = row;
  }
}

}  // namespace enfilade
