#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "portals/leak.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// Looks for the ways from one proposed cell to another that no portal cuts.  Refers to what it is
/// made of.
class LeakSearch {
 public:
  /// `cut`: one flag a voxel; `owner`: CellProposal's.
  LeakSearch(const VoxelGrid& voxels, const std::vector<std::uint8_t>& cut,
             const std::vector<std::uint16_t>& owner);

  /// The leak of `from` into `to`, its names left empty: through the middle of the shortest way
  /// between voxels of the two, of several as short the one in the middle.  Nothing if there is
  /// none.
  std::optional<Leak> find(std::uint16_t from, std::uint16_t to) const;

 private:
  struct Range {
    glm::ivec3 low, high;
  };
  const VoxelGrid& voxels_;
  const std::vector<std::uint8_t>& cut_;
  const std::vector<std::uint16_t>& owner_;
  std::vector<Range> ranges_;  // one a cell: of its voxels

  std::vector<glm::ivec3> voxelsOf(std::uint16_t cell) const;
};

}  // namespace enfilade
