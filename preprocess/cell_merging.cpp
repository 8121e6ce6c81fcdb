#include "preprocess/cell_merging.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace enfilade {

void mergeCells(const std::vector<std::uint16_t>& into, CellProposal& proposal) {
  std::vector<std::uint16_t> number(into.size());
  std::vector<int> kept;
  for (std::size_t c = 0; c < into.size(); ++c) {
    if (into[c] == CellProposal::kNobody) {
      number[c] = CellProposal::kNobody;
    } else if (into[c] == c) {
      number[c] = static_cast<std::uint16_t>(kept.size());
      kept.push_back(proposal.cell_storeys[c]);
    } else {
      number[c] = number[into[c]];  // lower, so numbered before
    }
  }
  for (std::uint16_t& owner : proposal.owner) {
    if (owner != CellProposal::kNobody) owner = number[owner];
  }
  proposal.cell_storeys = kept;
}

int dropCavities(const std::vector<float>& widths, const std::vector<Interface>& interfaces,
                 CellProposal& proposal) {
  constexpr float kNarrow = 1.0f;  // [m]
  std::vector<std::uint16_t> group(widths.size());
  std::iota(group.begin(), group.end(), std::uint16_t{0});
  const auto find = [&](std::uint16_t c) {
    while (group[c] != c) c = group[c] = group[group[c]];
    return c;
  };
  for (const Interface& interface : interfaces) {
    const std::uint16_t a = find(interface.low), b = find(interface.high);
    group[std::max(a, b)] = std::min(a, b);
  }
  std::vector<float> widest(widths.size(), 0.0f);
  for (std::size_t c = 0; c < widths.size(); ++c) {
    float& width = widest[find(static_cast<std::uint16_t>(c))];
    width = std::max(width, widths[c]);
  }
  std::vector<std::uint16_t> into(widths.size());
  int dropped = 0;
  for (std::size_t c = 0; c < widths.size(); ++c) {
    const bool narrow = widest[find(static_cast<std::uint16_t>(c))] < kNarrow;
    into[c] = narrow ? CellProposal::kNobody : static_cast<std::uint16_t>(c);
    dropped += narrow;
  }
  if (dropped == 0) return 0;
  mergeCells(into, proposal);
  proposal.log.push_back(fmt::format("left out {} narrow cavities that nothing leads to", dropped));
  return dropped;
}

}  // namespace enfilade
