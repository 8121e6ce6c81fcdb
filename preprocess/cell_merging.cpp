#include "preprocess/cell_merging.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace enfilade {

void mergeCells(const std::vector<std::uint16_t>& into, CellProposal& proposal) {
  std::vector<std::uint16_t> number(into.size());
  std::vector<int> kept;
  std::vector<std::string> names;
  for (std::size_t c = 0; c < into.size(); ++c) {
    if (into[c] == CellProposal::kNobody) {
      number[c] = CellProposal::kNobody;
    } else if (into[c] == c) {
      number[c] = static_cast<std::uint16_t>(kept.size());
      kept.push_back(proposal.cell_storeys[c]);
      names.push_back(proposal.cell_names[c]);
    } else {
      number[c] = number[into[c]];  // lower, so numbered before
    }
  }
  for (std::uint16_t& owner : proposal.owner) {
    if (owner != CellProposal::kNobody) owner = number[owner];
  }
  proposal.cell_storeys = kept;
  proposal.cell_names = names;
}

std::vector<std::uint16_t> joinedCells(std::size_t cells,
                                       const std::vector<Interface>& interfaces) {
  std::vector<std::uint16_t> group(cells);
  std::iota(group.begin(), group.end(), std::uint16_t{0});
  const auto find = [&](std::uint16_t c) {
    while (group[c] != c) c = group[c] = group[group[c]];
    return c;
  };
  for (const Interface& interface : interfaces) {
    const std::uint16_t a = find(interface.low), b = find(interface.high);
    group[std::max(a, b)] = std::min(a, b);
  }
  for (std::uint16_t& first : group) first = find(first);
  return group;
}

int dropCavities(const std::vector<float>& widths, const std::vector<std::uint8_t>& inside,
                 const std::vector<Interface>& interfaces, CellProposal& proposal) {
  constexpr float kNarrow = 1.0f;  // [m]
  const std::vector<std::uint16_t> group = joinedCells(widths.size(), interfaces);
  std::vector<float> widest(widths.size(), 0.0f);
  for (std::size_t c = 0; c < widths.size(); ++c) {
    widest[group[c]] = std::max(widest[group[c]], widths[c]);
  }
  std::vector<std::uint16_t> into(widths.size());
  int narrow = 0, solid = 0;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    const bool is_narrow = widest[group[c]] < kNarrow;
    into[c] = is_narrow || inside[c] ? CellProposal::kNobody : static_cast<std::uint16_t>(c);
    narrow += is_narrow;
    solid += inside[c] && !is_narrow;
  }
  if (narrow + solid == 0) return 0;
  mergeCells(into, proposal);
  if (narrow > 0) {
    proposal.log.push_back(
        fmt::format("left out {} narrow cavities that nothing leads to", narrow));
  }
  if (solid > 0) {
    proposal.log.push_back(fmt::format("left out {} insides of walls and other solids", solid));
  }
  return narrow + solid;
}

}  // namespace enfilade
