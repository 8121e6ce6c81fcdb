#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "portals/cell_graph.h"
#include "preprocess/voxel_grid.h"

namespace enfilade {

/// What a finder of cells (authored names, or the automatic one) proposes; cutCells() then makes it
/// true.
struct CellProposal {
  static constexpr std::uint16_t kNobody = 0xffff;

  std::vector<Storey> storeys;          ///< lowest first; at least one
  std::vector<std::string> cell_names;  ///< [0] is the exterior
  std::vector<int> cell_storeys;        ///< one a cell, index in storeys
  std::vector<Portal>
      portals;  ///< polygon, kind, name; front and back as the finder believes (kNoCell: unknown)
  std::vector<std::uint16_t> owner;  ///< the proposed cell of each voxel (VoxelGrid's index),
                                     ///< kNobody where solid or unknown
  std::vector<std::string> log;      ///< what was merged, cut, dropped, and why
};

/// Parameters of finding cells, in metres.
struct CellParameters {
  float voxel = 0.10f;          ///< [m] [0.02…1] edge of a voxel
  float slice_height = 1.2f;    ///< [m] [> 0] above the floor: where rooms are told apart
  float lintel_radius = 0.35f;  ///< [m] [> 0] half the deepest lintel that still marks a doorway
  float lintel_head = 2.6f;     ///< [m] [> 0] a lintel hangs no higher than this above the floor
  float merge_ratio = 0.5f;  ///< [0…1] basins joined by a neck wider than this share of the smaller
                             ///< one's width are one room
  float smallest_room = 1.0f;  ///< [m²] [≥ 0] smaller basins are merged
  float smallest_door = 0.5f;  ///< [m] [> 0] narrower passages are cracks, not doors
};

struct AuthoredNames;

/// Finds rooms storey by storey and an opening's plane between every two of them.  With `names`
/// what the author named comes first, his rooms (see claimRooms()) and his portals, and the
/// rest is found.  The same result run after run. Source: Haumont, Debeir & Sillion, Volumetric
/// Cell-and-Portal Generation, 2003; and DESIGN, section 11.
CellProposal findCells(const Building& building, std::span<const ObjectRole> roles,
                       const VoxelGrid& voxels, const CellParameters& parameters,
                       const AuthoredNames* names = nullptr);

}  // namespace enfilade
