#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Where free space that no portal cuts leads from one proposed cell to another [m]: the middle of
/// the shortest way between voxels of the two, of several as short the one in the middle.  Nothing
/// if there is none.  `cut`: one flag a voxel.
std::optional<glm::vec3> findLeak(const VoxelGrid& voxels, const std::vector<std::uint8_t>& cut,
                                  const std::vector<std::uint16_t>& owner, std::uint16_t from,
                                  std::uint16_t to);

}  // namespace enfilade
