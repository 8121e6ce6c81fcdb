#pragma once

#include <functional>
#include <vector>

#include "portals/house.h"
#include "preprocess/cut_cells.h"
#include "preprocess/patches.h"
#include "preprocess/voxel_grid.h"
#include "scene/building.h"

namespace enfilade {

/// Which cells can see each patch, as pairs sorted by patch, then cell, each pair once.
struct PatchCells {
  struct Claim {
    std::uint32_t patch = 0;
    CellId cell = 0;
    auto operator<=>(const Claim&) const = default;
  };
  std::vector<Claim> claims;

  void sortAndUnite();
};

/// Claims by touch: a patch belongs to the cells whose free voxels lie beside a voxel that it
/// touches; what none claims, to the nearest cell.
PatchCells claimByTouch(const Building& building, const Patches& patches, const VoxelGrid& voxels,
                        const CutCells& cells);

/// Adds the claims of sampled sight lines: rays from random free places in every cell, followed
/// through the portals that they cross, claim what they meet for the cell in which they meet it:
/// cracks and grazing views that voxels are too coarse for. The same claims for any number of
/// threads.  `progress` is told the share done.
void claimBySight(const Building& building, std::span<const ObjectRole> roles,
                  const Patches& patches, const CutCells& cells, int rays_per_cell, int threads,
                  const std::function<void(double)>& progress, PatchCells& claims);

/// The building with every object split so that each lies in one set of cells; order kept.  Roles
/// and cells one a new object.
struct SharedGeometry {
  Building building;
  std::vector<ObjectRole> roles;
  std::vector<std::vector<CellId>> cells;
};
SharedGeometry splitByCells(const Building& building, std::span<const ObjectRole> roles,
                            const Patches& patches, const PatchCells& claims);

}  // namespace enfilade
