#pragma once

#include <cstdint>
#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/storeys.h"

namespace enfilade {

/// What a column of a storey is at the height where rooms are told apart.
enum class ColumnKind : std::uint8_t {
  kWall,       ///< solid at the slice
  kFree,       ///<
  kSeparator,  ///< free, but under a lintel, or in a named door or glass: where rooms part
};

/// A storey seen from above, index x · size_z + z.
struct StoreySlice {
  int size_x = 0, size_z = 0;
  std::vector<ColumnKind> kind;
  std::vector<std::int32_t>
      low;  ///< [voxel] first of the free run at the slice; of kWall: the slice
  std::vector<std::int32_t> high;         ///< [voxel] one past its last, glass counting as its end
  std::vector<std::uint8_t> open_to_sky;  ///< nothing above, neither solid nor glass

  std::size_t index(int x, int z) const {
    return static_cast<std::size_t>(x) * static_cast<std::size_t>(size_z) +
           static_cast<std::size_t>(z);
  }
};

/// Slices a storey at parameters.slice_height above its floor.  A lintel is where the grey closing
/// of the free runs' tops, walls left out, lifts them, no higher than lintel_head above the floor;
/// over a sill it may hang higher.
StoreySlice sliceStorey(const VoxelGrid& voxels, const StoreyBand& storey,
                        const CellParameters& parameters);

}  // namespace enfilade
