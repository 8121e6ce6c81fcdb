#pragma once

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>

#include "models/mesh_builder.h"

namespace enfilade {

struct SurfacePoint {
  glm::dvec3 position{0};  ///< [m]
  double shade = 1;        ///< 0…1: how much sky reaches it
};

/// A curved surface over u, v in 0…1, seen from where +u turns counter-clockwise to +v.
struct CurvedSurface {
  std::function<SurfacePoint(double u, double v)> at;
  bool closed_u = true;  ///< u = 0 and u = 1 are one line
  bool closed_v = false;
  bool pole_low = false;   ///< all of v = 0 is one point
  bool pole_high = false;  ///< all of v = 1 is one point
  double aspect = 1;       ///< steps in u for each step in v, where both cost the same
  double share = 1;        ///< of its shape's triangles, beside the shape's other surfaces
  glm::dvec2 repeats{1};   ///< how often the picture repeats over u and v
};

/// Steps in u and v.
struct SurfaceGrid {
  std::uint32_t u = 8;
  std::uint32_t v = 4;
};

/// The grid that comes nearest to `triangles`, at least 6 × 3.
SurfaceGrid gridFor(const CurvedSurface& surface, double triangles);

std::size_t triangleCount(const CurvedSurface& surface, const SurfaceGrid& grid);

/// Adds exactly triangleCount triangles with smooth normals.
void raiseSurface(const CurvedSurface& surface, const SurfaceGrid& grid, MeshBuilder& mesh);

}  // namespace enfilade
