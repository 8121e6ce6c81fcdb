#include "preprocess/leak_search.h"

#include <algorithm>
#include <unordered_set>

#include "preprocess/cell_proposal.h"

namespace enfilade {

namespace {

constexpr float kBeyond = 1.5f;  // how far the path goes on where it has come out [m]

using Way = std::vector<glm::ivec3>;

/// The shortest way, a side of a voxel at each step, from any of `starts` over voxels that
/// `allowed` lets pass to one that `goal` takes, both ends among it; of several as short the one in
/// the middle.  Empty if there is none.
template <class Allowed, class Goal>
Way shortestWay(const VoxelGrid& voxels, const Way& starts, Allowed&& allowed, Goal&& goal) {
  struct Step {
    glm::ivec3 voxel;
    std::size_t before;
  };
  constexpr std::size_t kNone = ~std::size_t{0};
  std::vector<Step> steps;
  std::unordered_set<std::size_t> seen;  // looked up, never walked through
  for (const glm::ivec3& v : starts) {
    steps.push_back({v, kNone});
    seen.insert(voxels.index(v.x, v.y, v.z));
  }
  std::vector<std::size_t> ends;
  for (std::size_t begin = 0, end = steps.size(); begin < end && ends.empty();
       begin = end, end = steps.size()) {
    for (std::size_t s = begin; s < end; ++s) {
      if (goal(steps[s].voxel)) ends.push_back(s);
      for (const glm::ivec3& side : kVoxelSides) {
        const glm::ivec3 next = steps[s].voxel + side;
        if (!voxels.contains(next) || !allowed(next)) continue;
        if (seen.insert(voxels.index(next.x, next.y, next.z)).second) steps.push_back({next, s});
      }
    }
  }
  Way way;
  if (ends.empty()) return way;
  for (std::size_t s = ends[ends.size() / 2]; s != kNone; s = steps[s].before) {
    way.push_back(steps[s].voxel);
  }
  std::reverse(way.begin(), way.end());
  return way;
}

/// Whether nothing lies between two points, but for corners less than a tenth of a voxel thick.
template <class Passable>
bool isClear(const VoxelGrid& voxels, const glm::vec3& a, const glm::vec3& b, Passable&& passable) {
  const int steps = 1 + static_cast<int>(glm::distance(a, b) / (0.1f * voxels.voxel));
  for (int i = 0; i <= steps; ++i) {
    const float t = static_cast<float>(i) / static_cast<float>(steps);
    if (!passable(voxels.voxelOf(glm::mix(a, b, t)))) return false;
  }
  return true;
}

/// The same way in as few straight parts as go.
template <class Passable>
std::vector<glm::vec3> straightened(const VoxelGrid& voxels, const Way& way, Passable&& passable) {
  std::vector<glm::vec3> path{voxels.centerOf(way.front())};
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (!isClear(voxels, path.back(), voxels.centerOf(way[i]), passable)) {
      path.push_back(voxels.centerOf(way[i - 1]));
    }
  }
  path.push_back(voxels.centerOf(way.back()));
  return path;
}

glm::ivec3 middleOf(const Way& voxels) {
  glm::dvec3 sum(0);
  for (const glm::ivec3& v : voxels) sum += glm::dvec3(v);
  const glm::dvec3 mean = sum / static_cast<double>(voxels.size());
  const auto away = [&](const glm::ivec3& v) {
    const glm::dvec3 d = glm::dvec3(v) - mean;
    return glm::dot(d, d);
  };
  return *std::min_element(voxels.begin(), voxels.end(),
                           [&](const auto& a, const auto& b) { return away(a) < away(b); });
}

}  // namespace

LeakSearch::LeakSearch(const VoxelGrid& voxels, const std::vector<std::uint8_t>& cut,
                       const std::vector<std::uint16_t>& owner)
    : voxels_(voxels), cut_(cut), owner_(owner) {
  for (std::size_t i = 0; i < owner.size(); ++i) {
    if (owner[i] == CellProposal::kNobody) continue;
    const glm::ivec3 v = voxels.voxelAt(i);
    if (owner[i] >= ranges_.size()) ranges_.resize(owner[i] + 1u, {voxels.size, glm::ivec3(-1)});
    Range& range = ranges_[owner[i]];
    range.low = glm::min(range.low, v);
    range.high = glm::max(range.high, v);
  }
}

Way LeakSearch::voxelsOf(std::uint16_t cell) const {
  Way found;
  if (cell >= ranges_.size()) return found;
  const Range& range = ranges_[cell];
  glm::ivec3 v;
  for (v.x = range.low.x; v.x <= range.high.x; ++v.x) {
    for (v.z = range.low.z; v.z <= range.high.z; ++v.z) {
      for (v.y = range.low.y; v.y <= range.high.y; ++v.y) {
        const std::size_t i = voxels_.index(v.x, v.y, v.z);
        if (owner_[i] == cell && !cut_[i]) found.push_back(v);
      }
    }
  }
  return found;
}

std::optional<Leak> LeakSearch::find(std::uint16_t from, std::uint16_t to) const {
  const auto index = [&](const glm::ivec3& v) { return voxels_.index(v.x, v.y, v.z); };
  const auto passable = [&](const glm::ivec3& v) {
    return voxels_.contains(v) && !cut_[index(v)] && !(voxels_.bits[index(v)] & kVoxelSolid);
  };
  const auto within = [&](std::uint16_t cell) {
    return [&, cell](const glm::ivec3& v) { return passable(v) && owner_[index(v)] == cell; };
  };
  const Way room = voxelsOf(from);
  const Way crossing = shortestWay(
      voxels_, room,
      [&](const glm::ivec3& v) {
        const std::uint16_t owner = owner_[index(v)];
        return passable(v) && (owner == to || owner == CellProposal::kNobody);
      },
      within(to));
  if (crossing.empty()) return std::nullopt;
  const glm::ivec3 middle = middleOf(room);
  Way way = shortestWay(voxels_, {middle}, within(from),
                        [&](const glm::ivec3& v) { return v == crossing.front(); });
  const auto append = [&](const Way& more) {
    for (const glm::ivec3& v : more) {
      if (way.empty() || way.back() != v) way.push_back(v);
    }
  };
  append(crossing);
  append(shortestWay(voxels_, {crossing.back()}, within(to), [&](const glm::ivec3& v) {
    const glm::vec3 gone(v - crossing.back());
    return glm::length(gone) * voxels_.voxel >= kBeyond;
  }));
  Leak leak;
  leak.place = 0.5f * (voxels_.centerOf(crossing.front()) + voxels_.centerOf(crossing.back()));
  leak.path = straightened(voxels_, way, passable);
  return leak;
}

}  // namespace enfilade
