#include "preprocess/name_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "portals/house_names.h"

namespace enfilade {

namespace {

/// The height of most of a storey's floor [m].
float floorHeight(const VoxelGrid& voxels, const WallFaces& walls, const StoreyBand& band) {
  const float top = voxels.origin.y + float(band.floor + 1) * voxels.voxel;
  TurnedBox box;
  box.lo = voxels.origin;
  box.hi = voxels.origin + glm::vec3(voxels.size) * voxels.voxel;
  box.lo.y = top - 1.05f * voxels.voxel;
  box.hi.y = top + 0.05f * voxels.voxel;
  WallFaces::Face most{top, 0.0f};
  for (const WallFaces::Face& face : walls.facesAcross(box, 1)) {
    if (face.area > most.area) most = face;
  }
  return most.offset;
}

}  // namespace

void nameStoreys(const VoxelGrid& voxels, const WallFaces& walls,
                 const std::vector<StoreyBand>& bands, CellProposal& proposal) {
  for (std::size_t s = 0; s < bands.size(); ++s) {
    proposal.storeys.push_back(
        {fmt::format("storey-{}", s + 1), floorHeight(voxels, walls, bands[s])});
  }
}

void dropEmptyStoreys(CellProposal& proposal) {
  std::vector<int> number(proposal.storeys.size(), -1);
  for (std::size_t c = 1; c < proposal.cell_storeys.size(); ++c) {
    number[std::size_t(proposal.cell_storeys[c])] = 0;
  }
  if (std::find(number.begin(), number.end(), 0) == number.end()) number[0] = 0;
  std::vector<Storey> kept;
  for (std::size_t s = 0; s < number.size(); ++s) {
    if (number[s] < 0) continue;
    number[s] = static_cast<int>(kept.size());
    kept.push_back(std::move(proposal.storeys[s]));
    kept.back().name = fmt::format("storey-{}", kept.size());
  }
  for (std::size_t c = 1; c < proposal.cell_storeys.size(); ++c) {
    proposal.cell_storeys[c] = number[std::size_t(proposal.cell_storeys[c])];
  }
  proposal.storeys = std::move(kept);
}

void nameCells(CellProposal& proposal) {
  const std::vector<int>& storeys = proposal.cell_storeys;
  std::vector<int> rooms(proposal.storeys.size(), 0);
  proposal.cell_names[kExterior] = "exterior";
  std::set<std::string> taken(proposal.cell_names.begin(), proposal.cell_names.end());
  for (std::size_t c = 1; c < storeys.size(); ++c) {
    std::string& name = proposal.cell_names[c];
    while (name.empty()) {
      const int room = ++rooms[std::size_t(storeys[c])];
      const std::string next = proposal.storeys.size() > 1
                                   ? fmt::format("storey-{} room-{}", storeys[c] + 1, room)
                                   : fmt::format("room-{}", room);
      if (taken.insert(next).second) name = next;
    }
  }
}

void namePortals(CellProposal& proposal) {
  std::map<std::string, int> used;
  for (Portal& portal : proposal.portals) {
    if (!portal.name.empty() || portal.front == kNoCell || portal.back == kNoCell) continue;
    portal.name = fmt::format("{}-{}-{}", kindName(portal.kind), proposal.cell_names[portal.front],
                              proposal.cell_names[portal.back]);
    std::replace(portal.name.begin(), portal.name.end(), ' ', '-');
    const int number = ++used[portal.name];
    if (number > 1) portal.name += fmt::format("-{}", number);
  }
}

}  // namespace enfilade
