#include "portals/leaf_cover.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "portals/polygon.h"

namespace enfilade {

namespace {

constexpr float kStep = 0.01f;            // [m] between the points of a portal that are looked at
constexpr float kMostPoints = 1'000'000;  // of a portal; larger ones are never filled

/// Points all over a portal, and whether something stands before each, by the side from which it is
/// seen.
class PortalPoints {
 public:
  explicit PortalPoints(const Portal& portal) : portal_(portal) {
    const glm::vec3& normal = portal.plane.normal;
    right_ = glm::normalize(
        glm::cross(std::abs(normal.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0), normal));
    up_ = glm::cross(normal, right_);
    low_ = glm::vec2(std::numeric_limits<float>::infinity());
    glm::vec2 high(-std::numeric_limits<float>::infinity());
    for (const glm::vec3& corner : portal.polygon) {
      low_ = glm::min(low_, flat(corner));
      high = glm::max(high, flat(corner));
    }
    const glm::vec2 counts = glm::ceil((high - low_) / kStep);
    if (!(counts.x * counts.y <= kMostPoints)) return;
    size_ = glm::ivec2(counts);
    const auto count = static_cast<std::size_t>(size_.x) * static_cast<std::size_t>(size_.y);
    for (auto& covered : covered_) covered.assign(count, 0);
  }

  /// Covers what a triangle hides from each side that it is seen from.
  void cover(const std::array<glm::vec3, 3>& corners, bool double_sided) {
    const glm::vec2 a = flat(corners[0]), b = flat(corners[1]), c = flat(corners[2]);
    const float area = cross(b - a, c - a);
    if (area == 0) return;
    const glm::vec2 least = glm::min(a, glm::min(b, c)), most = glm::max(a, glm::max(b, c));
    const glm::ivec2 first =
        glm::max(glm::ivec2(glm::ceil((least - low_) / kStep - 0.5f)), glm::ivec2(0));
    const glm::ivec2 last =
        glm::min(glm::ivec2(glm::floor((most - low_) / kStep - 0.5f)), size_ - 1);
    for (int y = first.y; y <= last.y; ++y) {
      for (int x = first.x; x <= last.x; ++x) {
        const glm::vec2 p = pointAt(x, y);
        const float u = cross(b - a, p - a) / area, v = cross(c - b, p - b) / area,
                    w = cross(a - c, p - c) / area;
        if (u < 0 || v < 0 || w < 0) continue;
        if (double_sided || area > 0) covered_[0][index(x, y)] = 1;
        if (double_sided || area < 0) covered_[1][index(x, y)] = 1;
      }
    }
  }

  /// Whether from either side no more is left open than slits.
  bool areCovered() const {
    if (size_.x < 1 || size_.y < 1) return false;
    for (int y = 0; y < size_.y; ++y) {
      for (int x = 0; x < size_.x; ++x) {
        if (isHole(x, y)) return false;
      }
    }
    return true;
  }

 private:
  static float cross(const glm::vec2& a, const glm::vec2& b) { return a.x * b.y - a.y * b.x; }
  glm::vec2 flat(const glm::vec3& p) const { return {glm::dot(p, right_), glm::dot(p, up_)}; }
  glm::vec2 pointAt(int x, int y) const { return low_ + kStep * (glm::vec2(x, y) + 0.5f); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.x) +
           static_cast<std::size_t>(x);
  }
  bool isWithin(int x, int y) const {
    const glm::vec2 p = pointAt(x, y);
    const glm::vec3 at = p.x * right_ + p.y * up_ - portal_.plane.d * portal_.plane.normal;
    return distanceInPlane(portal_.polygon, portal_.plane, at) <= 0;
  }
  /// Whether four points together are open: more than a slit.
  bool isHole(int x, int y) const {
    if (x + 1 >= size_.x || y + 1 >= size_.y) return false;
    for (const auto& covered : covered_) {
      bool open = true;
      for (const int i : {0, 1, 2, 3}) open &= !covered[index(x + i % 2, y + i / 2)];
      for (const int i : {0, 1, 2, 3}) open = open && isWithin(x + i % 2, y + i / 2);
      if (open) return true;
    }
    return false;
  }

  const Portal& portal_;
  glm::vec3 right_, up_;
  glm::vec2 low_;
  glm::ivec2 size_{0};
  std::array<std::vector<std::uint8_t>, 2> covered_;  // as seen from the front, from behind
};

}  // namespace

float seenWithinWhenShut(const House& house, PortalId id, std::span<const DoorLeaf> leaves) {
  const Portal& portal = house.graph.portals[id];
  const Building& building = house.building;
  PortalPoints points(portal);
  float reach = 0;
  bool any = false;
  for (const DoorLeaf& leaf : leaves) {
    if (leaf.portal != id) continue;
    any = true;
    const Object& object = building.objects[leaf.object];
    const Mesh& mesh = building.meshOf(object);
    const Material& material = building.materialOf(object);
    const auto& positions = building.vertex_arrays[mesh.vertices].positions;
    const glm::mat4& world_from_object = building.worldFromObject(object);
    const bool mirrored = isMirrored(world_from_object);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
      std::array<glm::vec3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        corners[k] = glm::vec3(world_from_object * glm::vec4(positions[mesh.indices[i + k]], 1.0f));
        reach = std::max(reach, std::abs(portal.plane.signedDistance(corners[k])));
      }
      if (mirrored) std::swap(corners[1], corners[2]);
      if (material.alpha_mode == AlphaMode::kOpaque) points.cover(corners, material.double_sided);
    }
  }
  if (!any) return 0;
  return points.areCovered() ? reach : std::numeric_limits<float>::infinity();
}

void lookThroughShutPortals(House& house, std::span<const DoorLeaf> leaves) {
  for (PortalId id = 0; id < house.graph.portals.size(); ++id) {
    Portal& portal = house.graph.portals[id];
    portal.seen_within = portal.active ? 0 : seenWithinWhenShut(house, id, leaves);
  }
}

}  // namespace enfilade
