#pragma once

#include <string>
#include <vector>

#include "preprocess/interfaces.h"
#include "preprocess/voxel_grid.h"
#include "preprocess/wall_faces.h"

namespace enfilade {

/// A rectangle across an opening.
struct FittedPortal {
  glm::vec3 center{0};  ///< [m]
  glm::mat3 axes{1};    ///< u along its width, v along its height, n towards the low cell
  glm::vec2 half{0};    ///< [m] half its width and height
  bool fitted =
      false;  ///< it lies across the narrowest part; otherwise where the cells' voxels met
  int edges_snapped = 0;       ///< of four, onto planes of triangles
  bool plane_snapped = false;  ///< midway between two faces of a wall

  /// Counter-clockwise as seen from the low cell.
  std::vector<glm::vec3> polygon() const;
};

/// Fits a rectangle to an interface: square to the walls near by, slid to the smallest section of
/// free space within 0.7 m, midway between the faces of the wall there, its edges on the opening's.
/// It closes the opening as the voxels have it.  Where there is no such section, or it lies over
/// 0.35 m away, the interface's own extent.
FittedPortal fitPortal(const VoxelGrid& voxels, const WallFaces& walls, const Interface& interface);

}  // namespace enfilade
