#include "model_house.h"

#include "preprocess/authored_names.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/cut_cells.h"
#include "preprocess/object_roles.h"
#include "preprocess/voxel_grid.h"

namespace enfilade::testing {

House houseOf(Building building, const std::string& doors, const std::string& windows) {
  House house;
  const AuthoredNames names = takeAuthoredNames(building);
  house.building = std::move(building);
  house.object_roles = namedRoles(house.building, doors, windows);
  const VoxelGrid voxels = voxelise(house.building, house.object_roles, 0.1f);
  const CellProposal proposal = names.empty()
                                    ? findCells(house.building, house.object_roles, voxels, {})
                                    : authoredCells(names, voxels);
  const CutCells cut = cutCells(voxels, proposal);
  house.graph = cut.graph;
  house.grid = cut.grid;
  return house;
}

}  // namespace enfilade::testing
