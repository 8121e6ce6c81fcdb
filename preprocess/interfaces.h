#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "preprocess/voxel_grid.h"
#include "scene/geometry.h"

namespace enfilade {

/// Where two cells' voxels touch: a connected set of voxel faces.
struct Interface {
  std::uint16_t low = 0, high = 0;  ///< the two cells, low < high
  std::vector<glm::vec3> faces;     ///< centres [m]
  glm::vec3 centroid{0};            ///< of the faces [m]
  glm::vec3 normal{0};              ///< unit, from `high` into `low`: the faces' normals summed
  float planarity = 0;  ///< 0…1: 1 if the faces run one way along each axis, 0 if they cancel out
  Box bounds;           ///< of the faces' centres [m]
  /// [m] Where it ends below although free space does not: what passes there is another's.
  float foot = -std::numeric_limits<float>::infinity();
};

/// Every interface of the grid's owners, by cells and then by place.
std::vector<Interface> findInterfaces(const VoxelGrid& voxels,
                                      const std::vector<std::uint16_t>& owner);

}  // namespace enfilade
