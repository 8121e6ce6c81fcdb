#include "preprocess/assign_components.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <utility>

namespace enfilade {

namespace {

constexpr std::uint16_t kNobody = CellProposal::kNobody;

std::uint16_t strongestOwner(const OwnerCounts& owners) {
  std::uint16_t best = kNobody;
  std::size_t most = 0;
  for (const auto& [owner, count] : owners) {
    if (count > most) std::tie(best, most) = std::pair(owner, count);
  }
  return best;
}

}  // namespace

ComponentFacts gatherFacts(const VoxelGrid& grid, const FreeComponents& components,
                           const CellProposal& proposal) {
  ComponentFacts facts;
  facts.owners.resize(components.count);
  facts.volume.resize(components.count);
  facts.at_border.resize(components.count);
  facts.owned.resize(proposal.cell_names.size());
  for (const FreeComponents::Run& run : components.runs) {
    facts.volume[run.component] += static_cast<std::size_t>(run.end_y - run.begin_y);
    if (run.x == 0 || run.z == 0 || run.x == grid.size.x - 1 || run.z == grid.size.z - 1 ||
        run.end_y == grid.size.y) {
      facts.at_border[run.component] = 1;
    }
    for (int y = run.begin_y; y < run.end_y; ++y) {
      const std::uint16_t owner = proposal.owner[grid.index(run.x, y, run.z)];
      if (owner == kNobody) continue;
      ++facts.owners[run.component][owner];
      ++facts.owned[owner];
    }
  }
  return facts;
}

Assignment assignComponents(const ComponentFacts& facts, const CellProposal& proposal) {
  std::vector<std::uint16_t> merged(proposal.cell_names.size());
  std::iota(merged.begin(), merged.end(), std::uint16_t{0});
  const auto find = [&](std::uint16_t c) {
    while (merged[c] != c) c = merged[c];
    return c;
  };
  Assignment out;
  out.cell_of_component.assign(facts.owners.size(), kNobody);
  for (std::size_t c = 0; c < facts.owners.size(); ++c) {
    const std::uint16_t main =
        facts.at_border[c] ? std::uint16_t{kExterior} : strongestOwner(facts.owners[c]);
    out.cell_of_component[c] = main;
    if (main == kNobody) continue;
    for (const auto& [owner, count] : facts.owners[c]) {
      // Only a cell that lies mostly in this component has leaked; a sliver just changes hands.
      if (2 * count <= facts.owned[owner] || find(owner) == find(main)) continue;
      const std::uint16_t kept = std::min(find(owner), find(main));
      const std::uint16_t gone = std::max(find(owner), find(main));
      merged[gone] = kept;
      out.merges.push_back({gone, kept, owner, main});
    }
  }
  for (std::uint16_t& cell : out.cell_of_component) {
    if (cell != kNobody) cell = find(cell);
  }
  return out;
}

}  // namespace enfilade
