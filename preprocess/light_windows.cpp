#include "preprocess/light_windows.h"

#include <algorithm>

#include "preprocess/light_samples.h"
#include "preprocess/spherical_triangle.h"

namespace enfilade {
namespace {

constexpr float kFarAway = 1e4f;      // [m]
constexpr float kTooSmall = 1e-5f;    // integral of the cosine that is passed over
constexpr float kGlassBeyond = 0.5f;  // panes are looked for this far behind the portal [m]

/// A part of a portal above the point's horizon.
struct Part {
  SphericalTriangle triangle;
  const SkyPortal* portal;
  float integral;  // of the cosine over it
};

std::vector<Part> visibleParts(std::span<const SkyPortal> portals, const glm::vec3& point,
                               const glm::vec3& normal) {
  std::vector<Part> parts;
  for (const SkyPortal& portal : portals) {
    if (!(glm::dot(point - portal.polygon[0], portal.inward) > 0)) continue;
    const std::vector<glm::vec3> above = aboveHorizon(portal.polygon, point, normal);
    for (std::size_t i = 1; i + 1 < above.size(); ++i) {
      const std::array<glm::vec3, 3> corners{above[0], above[i], above[i + 1]};
      const float integral = cosineIntegral(corners, point, normal);
      if (!(integral > kTooSmall)) continue;
      const SphericalTriangle triangle(corners[0] - point, corners[1] - point, corners[2] - point);
      if (triangle.solidAngle() > 0) parts.push_back({triangle, &portal, integral});
    }
  }
  return parts;
}

}  // namespace

void Windows::sample(const glm::vec3& point, const glm::vec3& unit_normal, int count,
                     const std::function<void(const WindowView&)>& take) const {
  const std::vector<Part> parts = visibleParts(portals_, point, unit_normal);
  float total = 0;
  for (const Part& part : parts) total += part.integral;
  const float step = total / static_cast<float>(count);
  std::size_t at = 0;
  float before = 0;  // integral of the parts before `at`
  for (int j = 0; j < count && at < parts.size(); ++j) {
    const float place = (static_cast<float>(j) + 0.5f) * step;
    while (at + 1 < parts.size() && place > before + parts[at].integral) {
      before += parts[at++].integral;
    }
    const Part& part = parts[at];
    const auto n = static_cast<std::uint32_t>(j);
    WindowView view;
    view.direction = part.triangle.direction(
        std::clamp((place - before) / part.integral, 0.0f, 1.0f), radicalInverse(n, 2));
    const float outwards = -glm::dot(view.direction, part.portal->inward);
    if (!(outwards > 1e-6f)) continue;
    const float to_portal =
        glm::dot(point - part.portal->polygon[0], part.portal->inward) / outwards;
    view.hit = rays_.trace(point, view.direction, 0, kFarAway, 1, false);
    if (view.hit.distance >= 0 && view.hit.distance < to_portal) continue;
    view.weight = std::max(0.0f, glm::dot(view.direction, unit_normal)) *
                  part.triangle.solidAngle() * step / part.integral;
    if (rays_.hasGlass()) {
      float most = to_portal + kGlassBeyond;
      if (view.hit.distance >= 0) most = std::min(most, view.hit.distance * 0.9999f);
      view.passed = rays_.passed(point, view.direction, 0, most);
    }
    view.pick = radicalInverse(n, 3);
    take(view);
  }
}

}  // namespace enfilade
