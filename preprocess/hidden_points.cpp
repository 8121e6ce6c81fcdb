#include "preprocess/hidden_points.h"

#include <algorithm>

namespace enfilade {
namespace {

constexpr int kFarthest = 12;  // rings of triangles

using Pair = std::pair<std::uint32_t, std::uint32_t>;

/// Pairs of a hidden point and a neighbour along a triangle's edge.
std::vector<Pair> pairsOf(const LightPoints& points, const WorldGeometry& world,
                          const std::vector<std::uint8_t>& hidden) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i + 2 < world.indices.size(); i += 3) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = points.of_vertex[world.indices[i + k]];
      const std::uint32_t b = points.of_vertex[world.indices[i + (k + 1) % 3]];
      if (a == b) continue;
      if (hidden[a] != 0) pairs.emplace_back(a, b);
      if (hidden[b] != 0) pairs.emplace_back(b, a);
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

}  // namespace

HiddenPoints::HiddenPoints(const LightPoints& points, const WorldGeometry& world,
                           const GatheredLight& light) {
  std::vector<std::uint8_t> hidden(points.size(), 0);
  for (const LightChunk& chunk : light.chunks) {
    std::copy(chunk.hidden.begin(), chunk.hidden.end(),
              hidden.begin() + static_cast<std::ptrdiff_t>(chunk.first));
  }
  const std::vector<Pair> pairs = pairsOf(points, world, hidden);
  for (int ring = 0; ring < kFarthest; ++ring) {
    const std::size_t before = filled_.size();
    for (std::size_t from = 0, to = 0; from < pairs.size(); from = to) {
      const std::uint32_t point = pairs[from].first;
      const std::size_t had = neighbours_.size();
      for (; to < pairs.size() && pairs[to].first == point; ++to) {
        if (hidden[point] != 0 && hidden[pairs[to].second] == 0) {
          neighbours_.push_back(pairs[to].second);
        }
      }
      if (neighbours_.size() > had) {
        filled_.push_back({point, static_cast<std::uint32_t>(neighbours_.size())});
      }
    }
    for (std::size_t i = before; i < filled_.size(); ++i) hidden[filled_[i].point] = 0;
    if (filled_.size() == before) break;
  }
}

void HiddenPoints::fill(std::vector<glm::vec3>& light) const {
  std::size_t from = 0;
  for (const auto& [point, end] : filled_) {
    glm::vec3 sum(0);
    for (std::size_t i = from; i < end; ++i) sum += light[neighbours_[i]];
    light[point] = sum / static_cast<float>(end - from);
    from = end;
  }
}

}  // namespace enfilade
