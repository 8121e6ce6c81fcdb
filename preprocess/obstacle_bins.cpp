#include "preprocess/obstacle_bins.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

double distanceToTriangle(const glm::dvec3& p, const WorldTriangle& triangle) noexcept {
  const glm::dvec3 a(triangle[0]);
  const glm::dvec3 b(triangle[1]);
  const glm::dvec3 c(triangle[2]);
  const auto toSegment = [&](const glm::dvec3& from, const glm::dvec3& to) {
    const glm::dvec3 along = to - from;
    const double squared = glm::dot(along, along);
    const double t = squared > 0 ? std::clamp(glm::dot(p - from, along) / squared, 0.0, 1.0) : 0.0;
    return glm::length(p - (from + t * along));
  };
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double squared = glm::dot(normal, normal);
  if (squared > 0) {
    // Above the triangle's inside, the plane is nearest.
    const bool inside = glm::dot(glm::cross(b - a, p - a), normal) >= 0 &&
                        glm::dot(glm::cross(c - b, p - b), normal) >= 0 &&
                        glm::dot(glm::cross(a - c, p - c), normal) >= 0;
    if (inside) return std::abs(glm::dot(p - a, normal)) / std::sqrt(squared);
  }
  return std::min({toSegment(a, b), toSegment(b, c), toSegment(c, a)});
}

bool segmentMeetsTriangle(const glm::dvec3& a, const glm::dvec3& b,
                          const WorldTriangle& triangle) noexcept {
  const glm::dvec3 corner(triangle[0]);
  const glm::dvec3 e1 = glm::dvec3(triangle[1]) - corner;
  const glm::dvec3 e2 = glm::dvec3(triangle[2]) - corner;
  const glm::dvec3 along = b - a;
  const glm::dvec3 h = glm::cross(along, e2);
  const double determinant = glm::dot(e1, h);
  if (determinant == 0) return false;
  const glm::dvec3 s = a - corner;
  const double u = glm::dot(s, h) / determinant;
  const glm::dvec3 q = glm::cross(s, e1);
  const double v = glm::dot(along, q) / determinant;
  const double t = glm::dot(e2, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t <= 1;
}

ObstacleBins::ObstacleBins(const House& house, float bin) : bin_(bin) {
  const Box bounds = worldBounds(house.building);
  if (bounds.empty()) return;
  origin_ = {bounds.min.x, bounds.min.z};
  size_ = glm::ivec2(glm::floor((glm::vec2(bounds.max.x, bounds.max.z) - origin_) / bin_)) + 1;
  forEachObstacle(house, DoorsStand::kAsTheyAre,
                  [&](const WorldTriangle& t) { triangles_.push_back(t); });
  const auto eachBin = [&](const WorldTriangle& t, const auto& visit) {
    const glm::vec3 least = glm::min(t[0], glm::min(t[1], t[2]));
    const glm::vec3 most = glm::max(t[0], glm::max(t[1], t[2]));
    const glm::ivec2 low = binOf({least.x, least.z});
    const glm::ivec2 high = binOf({most.x, most.z});
    for (int x = low.x; x <= high.x; ++x) {
      for (int z = low.y; z <= high.y; ++z) visit(static_cast<std::size_t>(x * size_.y + z));
    }
  };
  first_.assign(static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y) + 1, 0);
  for (const WorldTriangle& t : triangles_) eachBin(t, [&](std::size_t b) { ++first_[b + 1]; });
  for (std::size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
  entries_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    eachBin(triangles_[i],
            [&](std::size_t b) { entries_[next[b]++] = static_cast<std::uint32_t>(i); });
  }
}

glm::ivec2 ObstacleBins::binOf(const glm::vec2& p) const noexcept {
  return glm::clamp(glm::ivec2(glm::floor((p - origin_) / bin_)), glm::ivec2(0), size_ - 1);
}

template <typename Visit>
void ObstacleBins::forEachIn(const glm::vec2& least, const glm::vec2& most,
                             const Visit& visit) const {
  if (triangles_.empty()) return;
  const glm::ivec2 low = binOf(least);
  const glm::ivec2 high = binOf(most);
  for (int x = low.x; x <= high.x; ++x) {
    for (int z = low.y; z <= high.y; ++z) {
      const auto b = static_cast<std::size_t>(x * size_.y + z);
      for (std::uint32_t i = first_[b]; i < first_[b + 1]; ++i) visit(triangles_[entries_[i]]);
    }
  }
}

float ObstacleBins::distance(const glm::vec3& p, float most) const {
  double least = most;
  const glm::vec2 at(p.x, p.z);
  forEachIn(at - most, at + most, [&](const WorldTriangle& t) {
    const float low = std::min({t[0].y, t[1].y, t[2].y});
    const float high = std::max({t[0].y, t[1].y, t[2].y});
    if (low - p.y > least || p.y - high > least) return;
    least = std::min(least, distanceToTriangle(glm::dvec3(p), t));
  });
  return static_cast<float>(least);
}

bool ObstacleBins::crosses(const glm::vec3& a, const glm::vec3& b) const {
  bool crossed = false;
  const glm::vec2 from(a.x, a.z);
  const glm::vec2 to(b.x, b.z);
  forEachIn(glm::min(from, to), glm::max(from, to), [&](const WorldTriangle& t) {
    crossed = crossed || segmentMeetsTriangle(glm::dvec3(a), glm::dvec3(b), t);
  });
  return crossed;
}

}  // namespace enfilade
