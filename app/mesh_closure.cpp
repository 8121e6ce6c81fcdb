#include "app/mesh_closure.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace enfilade {

namespace {

/// For every corner the first corner, in order of place, that stands where it does.
std::vector<std::uint32_t> weldByPlace(const std::vector<glm::vec3>& positions,
                                       const std::vector<std::uint32_t>& corners) {
  const auto before = [&](std::uint32_t a, std::uint32_t b) {
    const glm::vec3 &p = positions[corners[a]], &q = positions[corners[b]];
    return std::array{p.x, p.y, p.z} < std::array{q.x, q.y, q.z};
  };
  std::vector<std::uint32_t> order(corners.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t> welded(corners.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && !before(order[i - 1], order[i]);
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

}  // namespace

bool isClosed(const Building& building, const Mesh& mesh) {
  const std::vector<std::uint32_t> corners =
      weldByPlace(building.vertex_arrays[mesh.vertices].positions, mesh.indices);
  std::vector<std::array<std::uint32_t, 2>> edges;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const std::uint32_t a = corners[i], b = corners[i + 1], c = corners[i + 2];
    if (a == b || b == c || c == a) continue;
    for (const auto& [from, to] : {std::array{a, b}, std::array{b, c}, std::array{c, a}}) {
      edges.push_back({std::min(from, to), std::max(from, to)});
    }
  }
  std::sort(edges.begin(), edges.end());
  for (std::size_t i = 0; i < edges.size();) {
    const auto next =
        std::upper_bound(edges.begin() + static_cast<std::ptrdiff_t>(i), edges.end(), edges[i]);
    const auto end = static_cast<std::size_t>(next - edges.begin());
    if ((end - i) % 2 != 0) return false;
    i = end;
  }
  return !edges.empty();
}

}  // namespace enfilade
