#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/storeys.h"

namespace enfilade {

/// The heights of the storeys that a cell has seeds in [voxel].
struct SeedRange {
  int begin_y = 0, end_y = 0;  ///< end_y is one past the last
};

/// Where cells start to grow from.
struct RoomSeeds {
  std::vector<int> storeys;          ///< one a cell, [0] is the exterior
  std::vector<SeedRange> ranges;     ///< one a cell; of the exterior, everything
  std::vector<float> widths;         ///< [m] one a cell: of its plan at its widest
  std::vector<std::uint16_t> owner;  ///< one a voxel: the cell, or CellProposal::kNobody
  std::vector<std::string> log;
};

/// Slices every storey, divides it into rooms at lintels, named doors, glass and necks, and gives
/// the free runs at the slice to them, between the storey's floor and the next one's.  Plans that
/// touch the border or lie open to the sky are the exterior, and so are porches; a model without a
/// roof gets a virtual ceiling.
RoomSeeds seedRooms(const VoxelGrid& voxels, const std::vector<StoreyBand>& storeys,
                    const CellParameters& parameters);

}  // namespace enfilade
