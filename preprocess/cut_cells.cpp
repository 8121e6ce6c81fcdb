#include "preprocess/cut_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "preprocess/assign_components.h"
#include "preprocess/cut_voxels.h"
#include "preprocess/free_components.h"
#include "preprocess/leak_search.h"
#include "preprocess/portal_polygon.h"

namespace enfilade {

namespace {

constexpr std::uint16_t kNobody = CellProposal::kNobody;
// Smaller free spaces that no one proposed make no cell [m³].
constexpr float kLeastNewCell = 0.5f;

// The component on one side of a portal at `p`: the first free, uncut voxel along the normal.
std::uint32_t componentBeside(const VoxelGrid& grid, const std::vector<std::uint8_t>& cut,
                              const FreeComponents& components, const glm::vec3& p,
                              const glm::vec3& direction) {
  for (int step = 1; step <= 8; ++step) {
    const glm::ivec3 v =
        grid.voxelOf(p + direction * (0.5f * grid.voxel * static_cast<float>(step)));
    if (!grid.contains(v)) break;
    const std::size_t i = grid.index(v.x, v.y, v.z);
    if (grid.bits[i] & kVoxelSolid) break;
    if (cut[i] == 0) return components.componentAt(grid, v);
  }
  return FreeComponents::kNotFree;
}

using SidePair = std::pair<std::uint32_t, std::uint32_t>;  // components in front and behind

std::set<SidePair> sidesOf(const VoxelGrid& grid, const std::vector<std::uint8_t>& cut,
                           const FreeComponents& components, const Portal& portal) {
  std::set<SidePair> pairs;
  for (const glm::vec3& p : pointsWithin(portal.polygon, portal.plane, 0.5f * grid.voxel)) {
    const SidePair pair{componentBeside(grid, cut, components, p, portal.plane.normal),
                        componentBeside(grid, cut, components, p, -portal.plane.normal)};
    if (pair.first != FreeComponents::kNotFree && pair.second != FreeComponents::kNotFree) {
      pairs.insert(pair);
    }
  }
  return pairs;
}

// One attempt with a set of portals; those that part nothing are told, for the next attempt to
// leave out.
struct Attempt {
  std::vector<Portal> portals;  // front and back are proposed cells, or beyond them new ones
  std::vector<std::size_t> useless;
  std::vector<std::uint16_t> cell_of_component;
  std::vector<std::uint8_t> cut;
  FreeComponents components;
  std::uint16_t cells = 0;  // proposed and new
  std::vector<Assignment::Merge> merges;
};

Attempt attemptCut(const VoxelGrid& grid, const CellProposal& proposal,
                   const std::vector<Portal>& portals) {
  Attempt out;
  out.cut = cutVoxels(grid, portals);
  out.components = freeComponents(grid, out.cut);
  const ComponentFacts facts = gatherFacts(grid, out.components, proposal);
  Assignment assignment = assignComponents(facts, proposal);
  out.cell_of_component = std::move(assignment.cell_of_component);
  out.merges = std::move(assignment.merges);
  out.cells = static_cast<std::uint16_t>(proposal.cell_names.size());
  const float least_volume = kLeastNewCell / (grid.voxel * grid.voxel * grid.voxel);
  // Free space that no one proposed but that a portal opens to is a cell, unless it is a mere
  // pocket.
  const auto cellOf = [&](std::uint32_t component) {
    std::uint16_t& cell = out.cell_of_component[component];
    if (cell == kNobody && static_cast<float>(facts.volume[component]) >= least_volume) {
      cell = out.cells++;
    }
    return cell;
  };
  for (std::size_t i = 0; i < portals.size(); ++i) {
    std::set<std::pair<CellId, CellId>> cells;
    for (const auto& [front, back] : sidesOf(grid, out.cut, out.components, portals[i])) {
      const std::uint16_t f = cellOf(front);
      const std::uint16_t b = cellOf(back);
      if (f != b && f != kNobody && b != kNobody) cells.insert({f, b});
    }
    if (cells.empty()) out.useless.push_back(i);
    // A portal that touches several cells on a side stands once for each pair: it may show too
    // much, never too little.
    int number = 0;
    for (const auto& [front, back] : cells) {
      Portal portal = portals[i];
      if (++number > 1) portal.name += fmt::format("#{}", number);
      portal.front = front;
      portal.back = back;
      out.portals.push_back(std::move(portal));
    }
  }
  return out;
}

// Cells that exist, numbered anew: the exterior first, then in the order of the proposal.
std::vector<CellId> compactIds(const Attempt& attempt) {
  std::vector<std::uint8_t> used(attempt.cells, 0);
  used[kExterior] = 1;
  for (const std::uint16_t cell : attempt.cell_of_component) {
    if (cell != kNobody) used[cell] = 1;
  }
  std::vector<CellId> ids(attempt.cells, kNoCell);
  CellId next = 0;
  for (std::size_t c = 0; c < used.size(); ++c) {
    if (used[c]) ids[c] = next++;
  }
  return ids;
}

int storeyAt(const std::vector<Storey>& storeys, float y) {
  int storey = 0;
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    if (storeys[i].floor_y <= y + 0.3f) storey = static_cast<int>(i);
  }
  return storey;
}

void measureCells(const VoxelGrid& grid, const Attempt& attempt, const std::vector<CellId>& ids,
                  CellGraph& graph) {
  const float area = grid.voxel * grid.voxel;
  std::vector<std::pair<int, int>> last_column(graph.cells.size(), {-1, -1});
  for (const FreeComponents::Run& run : attempt.components.runs) {
    const std::uint16_t owner = attempt.cell_of_component[run.component];
    if (owner == kNobody) continue;
    const CellId id = ids[owner];
    Cell& cell = graph.cells[id];
    const glm::vec3 half(0.5f * grid.voxel);
    cell.bounds.extend(grid.centerOf({run.x, run.begin_y, run.z}) - half);
    cell.bounds.extend(grid.centerOf({run.x, run.end_y - 1, run.z}) + half);
    if (id == kExterior) continue;
    cell.volume += area * grid.voxel * static_cast<float>(run.end_y - run.begin_y);
    if (last_column[id] != std::pair(run.x, run.z)) cell.floor_area += area;
    last_column[id] = {run.x, run.z};
  }
}

CellGraph makeGraph(const VoxelGrid& grid, const CellProposal& proposal, const Attempt& attempt,
                    const std::vector<CellId>& ids) {
  CellGraph graph;
  graph.storeys = proposal.storeys;
  for (std::size_t c = 0; c < ids.size(); ++c) {
    if (ids[c] == kNoCell) continue;
    const bool proposed = c < proposal.cell_names.size();
    Cell cell;
    cell.name = proposed ? proposal.cell_names[c]
                         : fmt::format("cell-{}", c - proposal.cell_names.size() + 1);
    cell.storey = proposed ? proposal.cell_storeys[c] : 0;
    graph.cells.push_back(std::move(cell));
  }
  measureCells(grid, attempt, ids, graph);
  for (std::size_t c = proposal.cell_names.size(); c < ids.size(); ++c) {
    if (ids[c] == kNoCell) continue;
    Cell& cell = graph.cells[ids[c]];
    cell.storey = storeyAt(graph.storeys, cell.bounds.min.y);
  }
  for (Portal portal : attempt.portals) {
    portal.front = ids[portal.front];
    portal.back = ids[portal.back];
    graph.portals.push_back(std::move(portal));
  }
  linkCells(graph);
  return graph;
}

std::vector<CellGrid::Label> makeLabels(const VoxelGrid& grid, const Attempt& attempt,
                                        const std::vector<CellId>& ids) {
  std::vector<CellGrid::Label> labels(grid.bits.size(), CellGrid::kSolidVoxel);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (attempt.cut[i] && (grid.bits[i] & kVoxelSolid) == 0) labels[i] = CellGrid::kCutVoxel;
  }
  for (const FreeComponents::Run& run : attempt.components.runs) {
    const std::uint16_t owner = attempt.cell_of_component[run.component];
    if (owner == kNobody) continue;
    const std::size_t begin = grid.index(run.x, run.begin_y, run.z);
    std::fill_n(labels.begin() + static_cast<std::ptrdiff_t>(begin), run.end_y - run.begin_y,
                static_cast<CellGrid::Label>(ids[owner]));
  }
  return labels;
}

/// Tells which cells became one, and by what way.
void tellMerges(const VoxelGrid& voxels, const CellProposal& proposal, const Attempt& attempt,
                CutCells& out) {
  if (attempt.merges.empty()) return;
  const LeakSearch search(voxels, attempt.cut, proposal.owner);
  for (const Assignment::Merge& merge : attempt.merges) {
    const std::string& gone = proposal.cell_names[merge.gone];
    const std::string& kept = proposal.cell_names[merge.kept];
    std::string text = fmt::format("{}merged {} into {}: no portal closes the way between them",
                                   merge.kept == kExterior ? "LEAK: " : "", gone, kept);
    if (std::optional<Leak> leak = search.find(merge.leaked, merge.into)) {
      text += fmt::format(", which leads through ({:.1f}, {:.1f}, {:.1f})", leak->place.x,
                          leak->place.y, leak->place.z);
      leak->room = proposal.cell_names[merge.leaked];
      leak->into = proposal.cell_names[merge.into];
      if (merge.kept == kExterior) out.leaks.push_back(std::move(*leak));
    }
    out.log.push_back(std::move(text));
  }
}

}  // namespace

CutCells cutCells(const VoxelGrid& voxels, const CellProposal& proposal) {
  CutCells out;
  out.log = proposal.log;
  std::vector<Portal> portals = proposal.portals;
  for (Portal& portal : portals) portal.plane = planeOf(portal.polygon);
  Attempt attempt = attemptCut(voxels, proposal, portals);
  // Each round drops at least one portal, so this ends.
  while (!attempt.useless.empty()) {
    for (auto i = attempt.useless.rbegin(); i != attempt.useless.rend(); ++i) {
      const auto at = portals.begin() + static_cast<std::ptrdiff_t>(*i);
      out.log.push_back(fmt::format("dropped {}: it parts no two cells", at->name));
      portals.erase(at);
    }
    attempt = attemptCut(voxels, proposal, portals);
  }
  tellMerges(voxels, proposal, attempt, out);
  const std::vector<CellId> ids = compactIds(attempt);
  out.graph = makeGraph(voxels, proposal, attempt, ids);
  out.labels = makeLabels(voxels, attempt, ids);
  out.grid = CellGrid(voxels.origin, voxels.voxel, voxels.size, out.labels);
  return out;
}

}  // namespace enfilade
