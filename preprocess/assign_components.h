#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "preprocess/cell_proposal.h"
#include "preprocess/free_components.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// How many voxels of each proposed cell a component holds.
using OwnerCounts = std::map<std::uint16_t, std::size_t>;

/// What the cut components are made of, by the proposal.
struct ComponentFacts {
  std::vector<OwnerCounts> owners;      ///< one a component
  std::vector<std::size_t> volume;      ///< [voxels] one a component
  std::vector<std::uint8_t> at_border;  ///< not 0: reaches the edge of the grid, so it is outdoors
  std::vector<std::size_t> owned;       ///< voxels of each proposed cell in all
};

ComponentFacts gatherFacts(const VoxelGrid& grid, const FreeComponents& components,
                           const CellProposal& proposal);

/// The proposed cell that each component belongs to, proposed cells that leak into each other made
/// one.
struct Assignment {
  /// Two proposed cells between which no portal closes the way.
  struct Merge {
    std::uint16_t gone = 0, kept = 0;    ///< as which they go on
    std::uint16_t leaked = 0, into = 0;  ///< of those that they were made of, these are joined
  };
  std::vector<std::uint16_t> cell_of_component;  ///< CellProposal::kNobody: none
  std::vector<Merge> merges;
};

Assignment assignComponents(const ComponentFacts& facts, const CellProposal& proposal);

}  // namespace enfilade
