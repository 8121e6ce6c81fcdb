#include "preprocess/passages.h"

#include <cmath>

namespace enfilade {

namespace {

constexpr float kDeepest = 1.5f;  // [m] between its portals
constexpr float kParallel = 0.99f;
constexpr float kRoomier = 1.3f;  // times the space between the portals: it is a room
constexpr std::size_t kNoEnd = 0xffffffffu;

/// The interfaces of a cell.
struct Ends {
  std::size_t first = kNoEnd, second = kNoEnd;
  bool more = false;

  void add(std::size_t interface) {
    if (first == kNoEnd) {
      first = interface;
    } else if (second == kNoEnd) {
      second = interface;
    } else {
      more = true;
    }
  }
};

bool isPassage(const FittedPortal& a, const FittedPortal& b, float volume, float voxel) {
  if (!a.fitted || !b.fitted || std::abs(a.axes[2].y) > 0.5f) return false;
  if (std::abs(glm::dot(a.axes[2], b.axes[2])) < kParallel) return false;
  const float depth = std::abs(glm::dot(a.axes[2], b.center - a.center));
  const glm::vec3 aside =
      b.center - a.center - glm::dot(a.axes[2], b.center - a.center) * a.axes[2];
  if (depth > kDeepest || glm::length(aside) > 2 * voxel) return false;
  const float area = std::max(4 * a.half.x * a.half.y, 4 * b.half.x * b.half.y);
  return volume < kRoomier * area * (depth + 2 * voxel);
}

}  // namespace

std::vector<std::uint8_t> findPassages(const VoxelGrid& voxels,
                                       const std::vector<Interface>& interfaces,
                                       const std::vector<FittedPortal>& fitted,
                                       const CellProposal& proposal) {
  const std::size_t cells = proposal.cell_storeys.size();
  std::vector<Ends> ends(cells);
  for (std::size_t i = 0; i < interfaces.size(); ++i) {
    ends[interfaces[i].low].add(i);
    ends[interfaces[i].high].add(i);
  }
  std::vector<std::size_t> counts(cells, 0);
  for (const std::uint16_t owner : proposal.owner) {
    if (owner < cells) ++counts[owner];
  }
  std::vector<std::uint8_t> passage(cells, 0);
  const float voxel_volume = voxels.voxel * voxels.voxel * voxels.voxel;
  for (std::size_t c = kExterior + 1; c < cells; ++c) {
    const Ends& end = ends[c];
    if (end.second == kNoEnd || end.more || !proposal.cell_names[c].empty()) continue;
    // Of two in a row one stays, to be grown over the other.
    const auto beyond = [&](const Interface& i) { return i.low == c ? i.high : i.low; };
    if (passage[beyond(interfaces[end.first])] || passage[beyond(interfaces[end.second])]) continue;
    passage[c] = isPassage(fitted[end.first], fitted[end.second], float(counts[c]) * voxel_volume,
                           voxels.voxel);
  }
  return passage;
}

}  // namespace enfilade
