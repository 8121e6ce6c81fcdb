// Haumont, Debeir & Sillion, Volumetric Cell-and-Portal Generation, 2003, for the idea of growing
// cells from the wide parts of free space; the seeds come from a plan of each storey.
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "preprocess/authored_names.h"
#include "preprocess/cell_merging.h"
#include "preprocess/cell_proposal.h"
#include "preprocess/claim_rooms.h"
#include "preprocess/cut_voxels.h"
#include "preprocess/fit_portal.h"
#include "preprocess/grow_cells.h"
#include "preprocess/interfaces.h"
#include "preprocess/join_panes.h"
#include "preprocess/name_cells.h"
#include "preprocess/passages.h"
#include "preprocess/portal_kind.h"
#include "preprocess/room_seeds.h"
#include "preprocess/solid_insides.h"
#include "preprocess/split_foot.h"
#include "preprocess/storeys.h"
#include "preprocess/wall_faces.h"

namespace enfilade {

namespace {

constexpr float kPlanar = 0.6f;  // less: the cells wind about each other, no plane parts them
constexpr float kLargeInterface = 2.0f;  // [m²] of those, larger ones make one cell of two

/// The portals of all interfaces, and the pairs of cells that none can part.
struct Fits {
  std::vector<FittedPortal> portals;  ///< one an interface
  std::vector<std::uint16_t> into;    ///< one a cell: itself, or the cell that it is to be part of
  bool merged = false;
};

/// Fits a portal to every interface; parts those that no plane closes from the gap at their foot.
Fits fitAll(const VoxelGrid& voxels, const WallFaces& walls, std::vector<Interface>& interfaces,
            CellProposal& proposal) {
  Fits fits;
  fits.into.resize(proposal.cell_storeys.size());
  std::iota(fits.into.begin(), fits.into.end(), std::uint16_t{0});
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    fits.portals.push_back(fitPortal(voxels, walls, interfaces[i]));
    if (!fits.portals.back().fitted) {
      if (auto parts = splitFoot(voxels, interfaces[i])) {
        const FittedPortal upright = fitPortal(voxels, walls, parts->first);
        if (upright.fitted) {
          fits.portals.back() = upright;
          interfaces[i] = std::move(parts->first);
          interfaces.insert(interfaces.begin() + std::ptrdiff_t(i) + 1, std::move(parts->second));
          continue;
        }
      }
    }
    const Interface& interface = interfaces[i];
    const float area = float(interface.faces.size()) * voxels.voxel * voxels.voxel;
    if (fits.portals.back().fitted || interface.planarity >= kPlanar || area < kLargeInterface) {
      continue;
    }
    std::uint16_t a = interface.low, b = interface.high;
    while (fits.into[a] != a) a = fits.into[a];
    while (fits.into[b] != b) b = fits.into[b];
    if (a == b) continue;
    fits.into[std::max(a, b)] = std::min(a, b);
    fits.merged = true;
    proposal.log.push_back(
        fmt::format("merged two rooms at ({:.1f}, {:.1f}, {:.1f}): no plane parts them",
                    interface.centroid.x, interface.centroid.y, interface.centroid.z));
  }
  return fits;
}

/// Gives what nobody owns to the cells about it.
void fillUp(const VoxelGrid& voxels, CellProposal& proposal) {
  RoomSeeds seeds;
  seeds.ranges.assign(proposal.cell_storeys.size(), {0, voxels.size.y});
  seeds.owner = std::move(proposal.owner);
  growCells(voxels, seeds);
  proposal.owner = std::move(seeds.owner);
}

/// Gives passages to the cells at their ends, each as far as its middle.
bool openPassages(const VoxelGrid& voxels, const std::vector<std::uint8_t>& passage,
                  CellProposal& proposal) {
  std::vector<std::uint16_t> into(passage.size());
  int opened = 0;
  for (std::size_t c = 0; c < passage.size(); ++c) {
    into[c] = passage[c] ? CellProposal::kNobody : static_cast<std::uint16_t>(c);
    opened += passage[c];
  }
  if (opened == 0) return false;
  mergeCells(into, proposal);
  fillUp(voxels, proposal);
  proposal.log.push_back(
      fmt::format("took {} small rooms for what they are, doorways in thick walls", opened));
  return true;
}

/// Whether two interfaces of the same cells were fitted with the same rectangle.
bool isSame(const FittedPortal& a, const FittedPortal& b, float voxel) {
  return glm::distance(a.center, b.center) < voxel && glm::distance(a.half, b.half) < voxel &&
         glm::dot(a.axes[2], b.axes[2]) > 0.99f;
}

void addPortals(const VoxelGrid& voxels, const std::vector<Interface>& interfaces,
                const std::vector<FittedPortal>& fitted, CellProposal& proposal) {
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    bool again = false;
    for (std::size_t j = i; j-- > 0 && interfaces[j].low == interfaces[i].low &&
                            interfaces[j].high == interfaces[i].high;) {
      again |= isSame(fitted[i], fitted[j], voxels.voxel);
    }
    if (again) continue;
    Portal portal;
    portal.polygon = fitted[i].polygon();
    portal.plane = planeOf(portal.polygon);
    portal.front = interfaces[i].low;
    portal.back = interfaces[i].high;
    portal.kind = kindOf(voxels, fitted[i], interfaces[i].low == kExterior);
    const glm::vec3& at = fitted[i].center;
    if (!fitted[i].fitted) {
      proposal.log.push_back(
          fmt::format("at ({:.1f}, {:.1f}, {:.1f}) no narrowest section: cut where the rooms met",
                      at.x, at.y, at.z));
    }
    proposal.portals.push_back(std::move(portal));
  }
}

CellProposal findFrom(const Building& building, std::span<const ObjectRole> roles,
                      const VoxelGrid& voxels, const CellParameters& parameters,
                      const AuthoredNames* names) {
  const std::vector<StoreyBand> bands = findStoreys(voxels);
  RoomSeeds seeds = seedRooms(voxels, bands, parameters);
  growCells(voxels, seeds);
  const WallFaces walls(building, roles);
  CellProposal proposal;
  proposal.owner = std::move(seeds.owner);
  proposal.cell_storeys = std::move(seeds.storeys);
  proposal.cell_names.resize(proposal.cell_storeys.size());
  proposal.log = std::move(seeds.log);
  nameStoreys(voxels, walls, bands, proposal);
  const bool named = std::any_of(roles.begin(), roles.end(),
                                 [](ObjectRole role) { return role != ObjectRole::kFixed; });
  const auto meetings = [&] {
    std::vector<Interface> interfaces = findInterfaces(voxels, proposal.owner);
    joinPanes(voxels, named, interfaces);
    return interfaces;
  };
  std::vector<Interface> interfaces = meetings();
  const std::vector<std::uint8_t> inside = insidesOfSolids(
      building, roles, voxels, proposal.owner, proposal.cell_storeys.size(), interfaces);
  if (dropCavities(seeds.widths, inside, interfaces, proposal) > 0) {
    interfaces = meetings();
  }
  if (names != nullptr) {
    claimRooms(*names, authoredCells(*names, voxels), voxels, proposal);
    fillUp(voxels, proposal);
    interfaces = meetings();
  }
  Fits fits = fitAll(voxels, walls, interfaces, proposal);
  while (fits.merged) {
    mergeCells(fits.into, proposal);
    interfaces = meetings();
    fits = fitAll(voxels, walls, interfaces, proposal);
  }
  if (openPassages(voxels, findPassages(voxels, interfaces, fits.portals, proposal), proposal)) {
    interfaces = meetings();
    fits = fitAll(voxels, walls, interfaces, proposal);
  }
  dropEmptyStoreys(proposal);
  nameCells(proposal);
  addPortals(voxels, interfaces, fits.portals, proposal);
  namePortals(proposal);
  return proposal;
}

}  // namespace

CellProposal findCells(const Building& building, std::span<const ObjectRole> roles,
                       const VoxelGrid& voxels, const CellParameters& parameters,
                       const AuthoredNames* names) {
  if (names == nullptr) return findFrom(building, roles, voxels, parameters, nullptr);
  const std::vector<Portal> portals = authoredPortals(*names);
  VoxelGrid closed = voxels;  // where the author has put a portal nothing else is to be found
  const std::vector<std::uint8_t> cut = cutVoxels(voxels, portals);
  for (std::size_t i = 0; i < cut.size(); ++i) {
    if (cut[i]) closed.bits[i] |= kVoxelSolid;
  }
  CellProposal proposal = findFrom(building, roles, closed, parameters, names);
  proposal.log.insert(proposal.log.begin(), names->warnings.begin(), names->warnings.end());
  proposal.portals.insert(proposal.portals.begin(), portals.begin(), portals.end());
  return proposal;
}

}  // namespace enfilade
