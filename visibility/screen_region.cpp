#include "visibility/screen_region.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "visibility/screen_matrix.h"

namespace enfilade {

namespace {

constexpr double kLeastArea = 1e-12;         // [NDC²] of a region; far below that of the slack
constexpr float kContainsTolerance = 1e-6f;  // [NDC]

/// A region from corners that wind counter-clockwise; empty if they enclose nothing.
ScreenRegion regionOf(const View& view, std::span<const glm::dvec2> corners) {
  ScreenRegion region;
  double twice_area = 0;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    twice_area += cross(corners[i - 1] - corners[0], corners[i] - corners[0]);
  }
  if (!(twice_area > 2 * kLeastArea)) return region;

  const glm::dmat3 screen_from_direction = screenFromDirection(view);
  const glm::dvec3 eye(view.eye);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    region.corners.push_back(glm::vec2(corners[i]));
    const glm::dvec3 edge =
        glm::cross(glm::dvec3(corners[i], 1.0), glm::dvec3(corners[(i + 1) % corners.size()], 1.0));
    const glm::dvec3 normal = glm::normalize(edge * screen_from_direction);  // transposed times
    region.planes.push_back({glm::vec3(normal), static_cast<float>(-glm::dot(normal, eye))});
  }
  return region;
}

}  // namespace

ScreenRegion wholeScreen(const View& view) {
  const std::array<glm::dvec2, 4> corners = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  return regionOf(view, corners);
}

ScreenRegion clipRegion(const View& view, const ScreenRegion& region, const ScreenClip& clip) {
  if (clip.kind == ScreenClip::Kind::kNothing) return {};
  if (clip.kind == ScreenClip::Kind::kEverything) return region;
  // Sutherland & Hodgman, Reentrant Polygon Clipping, 1974.
  std::vector<glm::dvec2> corners(region.corners.begin(), region.corners.end());
  std::vector<glm::dvec2> clipped;
  for (const glm::dvec3& half_plane : clip.half_planes) {
    const auto inside = [&](const glm::dvec2& p) {
      return half_plane.x * p.x + half_plane.y * p.y + half_plane.z;
    };
    clipped.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec2& a = corners[i];
      const glm::dvec2& b = corners[(i + 1) % corners.size()];
      const double in_a = inside(a);
      const double in_b = inside(b);
      if (in_a >= 0) clipped.push_back(a);
      if ((in_a > 0 && in_b < 0) || (in_a < 0 && in_b > 0)) {
        clipped.push_back(glm::mix(a, b, in_a / (in_a - in_b)));
      }
    }
    corners.swap(clipped);
    if (corners.size() < 3) return {};
  }
  // Corners that single precision cannot tell apart have no edge between them.
  const auto same = [](const glm::dvec2& a, const glm::dvec2& b) {
    return glm::all(glm::lessThan(glm::abs(a - b), glm::dvec2(1e-7)));
  };
  corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
  while (corners.size() > 1 && same(corners.front(), corners.back())) corners.pop_back();
  return regionOf(view, corners);
}

ScreenRegion clipRegion(const View& view, const ScreenRegion& region,
                        std::span<const glm::vec3> polygon, float slack_ndc) {
  return clipRegion(view, region, screenClip(view, polygon, slack_ndc));
}

ScreenRegion boundingRegion(const View& view, std::span<const ScreenRegion> regions) {
  glm::dvec2 least(1);
  glm::dvec2 most(-1);
  for (const ScreenRegion& region : regions) {
    for (const glm::vec2& corner : region.corners) {
      least = glm::min(least, glm::dvec2(corner));
      most = glm::max(most, glm::dvec2(corner));
    }
  }
  const std::array<glm::dvec2, 4> corners = {{least, {most.x, least.y}, most, {least.x, most.y}}};
  return regionOf(view, corners);
}

bool contains(const ScreenRegion& outer, const ScreenRegion& inner) noexcept {
  if (outer.empty()) return inner.empty();
  for (std::size_t i = 0; i < outer.corners.size(); ++i) {
    const glm::dvec2 a(outer.corners[i]);
    const glm::dvec2 edge = glm::dvec2(outer.corners[(i + 1) % outer.corners.size()]) - a;
    const double least = -kContainsTolerance * glm::length(edge);
    for (const glm::vec2& corner : inner.corners) {
      if (cross(edge, glm::dvec2(corner) - a) < least) return false;
    }
  }
  return true;
}

bool mayTouch(std::span<const Plane> planes, const Box& box) noexcept {
  if (box.empty()) return false;
  for (const Plane& plane : planes) {
    const glm::vec3 innermost(plane.normal.x >= 0 ? box.max.x : box.min.x,
                              plane.normal.y >= 0 ? box.max.y : box.min.y,
                              plane.normal.z >= 0 ? box.max.z : box.min.z);
    // Rounding of the plane and of this sum grows with the terms, not with the distance.
    const float rounding =
        1e-6f * (glm::dot(glm::abs(plane.normal), glm::abs(innermost)) + std::abs(plane.d));
    if (plane.signedDistance(innermost) < -rounding) return false;
  }
  return true;
}

bool mayBeSeen(const ScreenRegion& region, const Box& box) noexcept {
  return !region.empty() && mayTouch(region.planes, box);
}

}  // namespace enfilade
