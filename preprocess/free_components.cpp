#include "preprocess/free_components.h"

#include <algorithm>
#include <numeric>

namespace enfilade {

namespace {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // The lower index leads, so that numbering does not depend on the order of joins.
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

void collectRuns(const VoxelGrid& grid, const std::vector<std::uint8_t>& cut, FreeComponents& out) {
  for (int x = 0; x < grid.size.x; ++x) {
    for (int z = 0; z < grid.size.z; ++z) {
      out.first.push_back(static_cast<std::uint32_t>(out.runs.size()));
      const std::size_t column = grid.index(x, 0, z);
      const auto isFree = [&](int y) {
        const std::size_t i = column + static_cast<std::size_t>(y);
        return (grid.bits[i] & kVoxelSolid) == 0 && cut[i] == 0;
      };
      for (int y = 0; y < grid.size.y;) {
        if (!isFree(y)) {
          ++y;
          continue;
        }
        const int begin = y;
        while (y < grid.size.y && isFree(y)) ++y;
        out.runs.push_back({x, z, begin, y, 0});
      }
    }
  }
  out.first.push_back(static_cast<std::uint32_t>(out.runs.size()));
}

// Joins the runs of two neighbouring columns that overlap in height.
void joinColumns(const FreeComponents& c, std::size_t a, std::size_t b, UnionFind& sets) {
  std::uint32_t i = c.first[a];
  std::uint32_t j = c.first[b];
  while (i < c.first[a + 1] && j < c.first[b + 1]) {
    const FreeComponents::Run& p = c.runs[i];
    const FreeComponents::Run& q = c.runs[j];
    if (p.begin_y < q.end_y && q.begin_y < p.end_y) sets.join(i, j);
    (p.end_y < q.end_y ? i : j)++;
  }
}

}  // namespace

FreeComponents freeComponents(const VoxelGrid& grid, const std::vector<std::uint8_t>& cut) {
  FreeComponents out;
  collectRuns(grid, cut, out);
  UnionFind sets(out.runs.size());
  const auto nz = static_cast<std::size_t>(grid.size.z);
  for (std::size_t column = 0; column + 1 < out.first.size(); ++column) {
    if (column % nz + 1 < nz) joinColumns(out, column, column + 1, sets);
    if (column + nz + 1 < out.first.size()) joinColumns(out, column, column + nz, sets);
  }
  std::vector<std::uint32_t> number(out.runs.size(), FreeComponents::kNotFree);
  for (std::uint32_t i = 0; i < out.runs.size(); ++i) {
    const std::uint32_t root = sets.find(i);
    if (number[root] == FreeComponents::kNotFree) number[root] = out.count++;
    out.runs[i].component = number[root];
  }
  return out;
}

std::uint32_t FreeComponents::componentAt(const VoxelGrid& grid, const glm::ivec3& v) const {
  if (!grid.contains(v)) return kNotFree;
  const std::size_t column = static_cast<std::size_t>(v.x) * static_cast<std::size_t>(grid.size.z) +
                             static_cast<std::size_t>(v.z);
  for (std::uint32_t i = first[column]; i < first[column + 1]; ++i) {
    if (v.y < runs[i].begin_y) break;
    if (v.y < runs[i].end_y) return runs[i].component;
  }
  return kNotFree;
}

}  // namespace enfilade
