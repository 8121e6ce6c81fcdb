#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Connected components (6-neighbours) of the free voxels that no portal cuts.
struct FreeComponents {
  static constexpr std::uint32_t kNotFree = 0xffffffffu;

  /// A vertical run of free voxels.
  struct Run {
    int x = 0, z = 0;
    int begin_y = 0, end_y = 0;
    std::uint32_t component = 0;
  };

  std::vector<Run> runs;  ///< by (x, z), then y
  std::vector<std::uint32_t>
      first;                ///< size.x · size.z + 1 entries into runs; column x · size.z + z
  std::uint32_t count = 0;  ///< components, numbered in order of their first run

  std::uint32_t componentAt(const VoxelGrid& grid, const glm::ivec3& v) const;
};

/// `cut` has one flag a voxel (VoxelGrid's index): not 0 where a portal passes.
FreeComponents freeComponents(const VoxelGrid& grid, const std::vector<std::uint8_t>& cut);

}  // namespace enfilade
