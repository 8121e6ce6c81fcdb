#include "preprocess/given_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace enfilade {
namespace {

/// The cell of each label that the grid may hold.
std::map<CellGrid::Label, std::uint16_t> cellsByLabel(const GivenGraph& given) {
  std::map<CellGrid::Label, std::uint16_t> cells;
  for (std::size_t c = 0; c < given.labels.size(); ++c) {
    cells[static_cast<CellGrid::Label>(given.labels[c])] = static_cast<std::uint16_t>(c);
  }
  return cells;
}

/// Calls visit(voxel, owner) for the free voxels of a box that nobody owns yet.
template <class Visit>
void forEachUnowned(const VoxelGrid& grid, const Box& box, CellProposal& proposal, Visit&& visit) {
  const glm::ivec3 first = glm::max(grid.voxelOf(box.min), glm::ivec3(0));
  const glm::ivec3 last = glm::min(grid.voxelOf(box.max), grid.size - 1);
  for (int x = first.x; x <= last.x; ++x) {
    for (int z = first.z; z <= last.z; ++z) {
      for (int y = first.y; y <= last.y; ++y) {
        const std::size_t i = grid.index(x, y, z);
        const bool free = (grid.bits[i] & kVoxelSolid) == 0;
        if (free && proposal.owner[i] == CellProposal::kNobody) {
          visit(glm::ivec3(x, y, z), proposal.owner[i]);
        }
      }
    }
  }
}

void ownByGrid(const GivenGraph& given, const VoxelGrid& voxels, CellProposal& proposal) {
  const auto cells = cellsByLabel(given);
  const Box all{voxels.centerOf(glm::ivec3(0)), voxels.centerOf(voxels.size - 1)};
  forEachUnowned(voxels, all, proposal, [&](const glm::ivec3& v, std::uint16_t& owner) {
    const auto cell = cells.find(given.grid->labelAt(given.grid->voxelOf(voxels.centerOf(v))));
    if (cell != cells.end()) owner = cell->second;
  });
}

/// Cells whose voxels no grid knows: the smallest first, since a room within a room's box keeps its
/// own.
std::vector<std::size_t> unknownToGrid(const GivenGraph& given) {
  std::set<CellId> known;
  if (given.grid) {
    for (const CellGrid::Run& run : given.grid->runs()) known.insert(run.label);
  }
  std::vector<std::size_t> cells;
  for (std::size_t c = 1; c < given.labels.size(); ++c) {  // the exterior is what is left
    if (!known.contains(given.labels[c])) cells.push_back(c);
  }
  const auto volume = [&](std::size_t c) {
    const glm::vec3 size = given.graph.cells[c].bounds.size();
    return size.x * size.y * size.z;
  };
  std::stable_sort(cells.begin(), cells.end(),
                   [&](std::size_t a, std::size_t b) { return volume(a) < volume(b); });
  return cells;
}

void ownByBounds(const GivenGraph& given, const VoxelGrid& voxels, CellProposal& proposal) {
  for (const std::size_t c : unknownToGrid(given)) {
    const Box& bounds = given.graph.cells[c].bounds;
    if (bounds.empty()) continue;
    forEachUnowned(voxels, bounds, proposal, [&](const glm::ivec3& v, std::uint16_t& owner) {
      if (bounds.contains(voxels.centerOf(v))) owner = static_cast<std::uint16_t>(c);
    });
  }
}

/// A portal that joins several pairs of cells stands once for each in a house, but cuts once.
bool isSame(const Portal& a, const Portal& b) { return a.polygon == b.polygon; }

void turn(Portal& portal) {
  std::reverse(portal.polygon.begin(), portal.polygon.end());
  portal.plane = {-portal.plane.normal, -portal.plane.d};
  std::swap(portal.front, portal.back);
}

/// Turns a portal to how the graph gives it, or logs that it joins other cells.
void settle(Portal& portal, const CellGraph& wanted, CutCells& cells) {
  const std::string front = cells.graph.cells[portal.front].name;
  const std::string back = cells.graph.cells[portal.back].name;
  const Portal* reversed = nullptr;
  const Portal* other = nullptr;
  for (const Portal& said : wanted.portals) {
    if (!isSame(said, portal)) continue;
    const std::string& said_front = wanted.cells[said.front].name;
    const std::string& said_back = wanted.cells[said.back].name;
    if (said_front == front && said_back == back) return;
    (said_front == back && said_back == front ? reversed : other) = &said;
  }
  if (reversed != nullptr) {
    turn(portal);
  } else if (other != nullptr) {
    cells.log.push_back(fmt::format("{} is given between {} and {}; it joins {} and {}",
                                    portal.name, wanted.cells[other->front].name,
                                    wanted.cells[other->back].name, front, back));
  }
}

}  // namespace

CellProposal givenCells(const GivenGraph& given, const VoxelGrid& voxels) {
  CellProposal proposal;
  proposal.storeys = given.graph.storeys;
  for (const Cell& cell : given.graph.cells) {
    proposal.cell_names.push_back(cell.name);
    proposal.cell_storeys.push_back(cell.storey);
  }
  for (const Portal& portal : given.graph.portals) {
    const auto& known = proposal.portals;
    const bool again =
        std::any_of(known.begin(), known.end(), [&](const Portal& p) { return isSame(p, portal); });
    if (!again) proposal.portals.push_back(portal);
  }
  proposal.owner.assign(voxels.bits.size(), CellProposal::kNobody);
  ownByBounds(given, voxels, proposal);  // a new cell before that out of which it is cut
  if (given.grid) ownByGrid(given, voxels, proposal);
  return proposal;
}

void compareWithGiven(const GivenGraph& given, CutCells& cells) {
  for (Portal& portal : cells.graph.portals) settle(portal, given.graph, cells);
  for (const Cell& cell : given.graph.cells) {
    const auto& made = cells.graph.cells;
    const bool is_there =
        std::any_of(made.begin(), made.end(), [&](const Cell& c) { return c.name == cell.name; });
    if (!is_there) cells.log.push_back(fmt::format("{} is no cell of its own", cell.name));
  }
}

}  // namespace enfilade
