#include <algorithm>
#include <cmath>

#include "visibility/screen_matrix.h"
#include "visibility/screen_region.h"

namespace enfilade {

namespace {

constexpr double kEyeDistance = 1e-4;  // [m] nearer than this the eye is on the polygon
constexpr double kLeastDepth = 1e-6;   // [m] what is nearer to the eye's own plane is cut off

bool isOn(std::span<const glm::vec3> polygon, const glm::dvec3& eye) {
  // The eye is on the polygon if it is near its plane and inside all edges, or near an edge.
  glm::dvec3 area(0);
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(polygon[i]) - eye;
    const glm::dvec3 b = glm::dvec3(polygon[(i + 1) % polygon.size()]) - eye;
    area += glm::cross(a, b);
    const glm::dvec3 edge = b - a;
    const double length2 = glm::dot(edge, edge);
    const double t = length2 > 0 ? std::clamp(-glm::dot(a, edge) / length2, 0.0, 1.0) : 0.0;
    if (glm::length(a + t * edge) <= kEyeDistance) return true;
  }
  const double length = glm::length(area);
  if (length == 0) return false;
  const glm::dvec3 normal = area / length;
  if (std::abs(glm::dot(normal, glm::dvec3(polygon[0]) - eye)) > kEyeDistance) return false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(polygon[i]) - eye;
    const glm::dvec3 b = glm::dvec3(polygon[(i + 1) % polygon.size()]) - eye;
    if (glm::dot(glm::cross(a, b), normal) < 0) return false;
  }
  return true;
}

/// The corners in NDC of the part of `polygon` that lies before the eye.  What is cut off next to
/// the eye's own plane is off the screen, for the eye is not on the polygon.
std::vector<glm::dvec2> projected(const View& view, std::span<const glm::vec3> polygon) {
  const glm::dmat3 screen_from_direction = screenFromDirection(view);
  const glm::dvec3 depth_direction(screen_from_direction[0][2], screen_from_direction[1][2],
                                   screen_from_direction[2][2]);
  const double least_w = kLeastDepth * glm::length(depth_direction);
  const auto toScreen = [&](const glm::vec3& p) {
    return screen_from_direction * (glm::dvec3(p) - glm::dvec3(view.eye));
  };
  std::vector<glm::dvec2> points;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 a = toScreen(polygon[i]);
    const glm::dvec3 b = toScreen(polygon[(i + 1) % polygon.size()]);
    if (a.z >= least_w) points.push_back(glm::dvec2(a) / a.z);
    if ((a.z >= least_w) != (b.z >= least_w)) {
      points.push_back(glm::dvec2(glm::mix(a, b, (least_w - a.z) / (b.z - a.z))) / least_w);
    }
  }
  return points;
}

/// The convex hull, counter-clockwise, in place (Andrew's monotone chain).  A polygon seen edge-on
/// may be bent by rounding: its hull never is.
std::vector<glm::dvec2> convexHull(std::vector<glm::dvec2> points) {
  std::sort(points.begin(), points.end(), [](const glm::dvec2& a, const glm::dvec2& b) {
    return a.x < b.x || (a.x == b.x && a.y < b.y);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<glm::dvec2> hull;
  const auto addChain = [&](auto begin, auto end) {
    const std::size_t base = hull.size();
    for (auto p = begin; p != end; ++p) {
      while (hull.size() >= base + 2 &&
             cross(hull.back() - hull[hull.size() - 2], *p - hull.back()) <= 0) {
        hull.pop_back();
      }
      hull.push_back(*p);
    }
    hull.pop_back();  // the other chain's first
  };
  addChain(points.begin(), points.end());
  addChain(points.rbegin(), points.rend());
  return hull;
}

}  // namespace

ScreenClip screenClip(const View& view, std::span<const glm::vec3> polygon, float slack_ndc) {
  if (isOn(polygon, glm::dvec3(view.eye))) return {ScreenClip::Kind::kEverything, {}};
  const std::vector<glm::dvec2> hull = convexHull(projected(view, polygon));
  if (hull.empty()) return {};

  ScreenClip clip{ScreenClip::Kind::kPart, {}};
  const double slack = slack_ndc;
  glm::dvec2 least = hull[0];
  glm::dvec2 most = hull[0];
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2 edge = hull[(i + 1) % hull.size()] - hull[i];
    const double length = glm::length(edge);
    least = glm::min(least, hull[i]);
    most = glm::max(most, hull[i]);
    if (length == 0) continue;
    const glm::dvec2 inward = glm::dvec2(-edge.y, edge.x) / length;
    clip.half_planes.push_back({inward, slack - glm::dot(inward, hull[i])});
  }
  // The widened edges of an acute corner meet far out: the bounding rectangle cuts it off.
  clip.half_planes.push_back({1, 0, 4 * slack - least.x});
  clip.half_planes.push_back({-1, 0, 4 * slack + most.x});
  clip.half_planes.push_back({0, 1, 4 * slack - least.y});
  clip.half_planes.push_back({0, -1, 4 * slack + most.y});
  return clip;
}

}  // namespace enfilade
