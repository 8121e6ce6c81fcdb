#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/voxel_grid.h"
#include "preprocess/wall_faces.h"

namespace enfilade {

/// A window in planes perpendicular to a direction: axes u, v and n (columns of `axes`,
/// right-handed) through `center`, divided into square pixels.
struct SectionWindow {
  glm::vec3 center{0};  ///< [m]
  glm::mat3 axes{1};    ///< u, v, n
  glm::vec2 lo{0};      ///< [m] least corner, along u and v from the centre
  float pixel = 0.05f;  ///< [m]
  int size_u = 0, size_v = 0;
  bool footed = false;  ///< it ends at its least v: what is free beyond does not make it open

  glm::vec3 pointAt(int u, int v, float n) const {
    return center + axes * glm::vec3(lo + (glm::vec2(u, v) + 0.5f) * pixel, n);
  }
};

/// The free part of a plane in a window that hangs together with given points.
struct Section {
  std::vector<std::uint8_t> inside;  ///< index u · size_v + v
  int count = 0;                     ///< [pixels]
  bool open = false;                 ///< it reaches the window's border
  glm::ivec2 first{0}, end{0};       ///< its bounds [pixels]
};

/// The section of the voxels' free space by the plane at `n` [m] along the window's normal, as far
/// as it hangs together with `seeds` (projected onto the plane; those that are not free there do
/// not count).
Section sectionAt(const VoxelGrid& voxels, const SectionWindow& window,
                  const std::vector<glm::vec3>& seeds, float n);

}  // namespace enfilade
