#include "ibr/sight_lines.h"

#include <algorithm>
#include <cmath>

#include "ibr/portal_window.h"
#include "portals/polygon.h"

namespace enfilade {
namespace {

constexpr double kSameSurface = 5e-4;  // [of the distance] what rays in floats may differ by

bool contains(const std::vector<glm::ivec2>& spans, const glm::dvec2& at) noexcept {
  if (!(at.x >= 0 && at.y >= 0 && at.y < static_cast<double>(spans.size()))) return false;
  const glm::ivec2& span = spans[static_cast<std::size_t>(at.y)];
  return at.x >= span.x && at.x < span.y;
}

}  // namespace

SightLines::SightLines(const RayCaster& caster, const PlanarCamera& central,
                       const std::vector<glm::dvec3>& viewpoints, const Portal& portal,
                       bool from_front, const ImageParameters& parameters, double far_depth)
    : caster_(caster) {
  const auto grown = grownPolygon(portal.polygon, portal.plane, parameters.portal_margin);
  for (const glm::dvec3& at : viewpoints) {
    Eye eye;
    eye.camera = refined(portalCamera(portal, from_front, at, parameters), parameters.rays);
    eye.from_central = warpTransform(central, eye.camera);
    eye.most = far_depth / imagePlaneDistance(eye.camera);
    eye.through = pixelsThrough(portal.polygon, eye.camera);
    eye.by_margin = pixelsThrough(grown, eye.camera);
    eyes_.push_back(std::move(eye));
  }
}

SightLines::Place SightLines::placeIn(const Eye& eye, const RayPoint& point) const noexcept {
  const glm::dvec3 h = eye.from_central.homogeneous(point.u, point.v, point.disparity);
  Place place;
  place.distance = -1;
  if (!(h.z > 0)) return place;
  const glm::dvec2 at = glm::dvec2(h) / h.z;
  const bool through = contains(eye.through, at);
  if (!through && !contains(eye.by_margin, at)) return place;
  place.direction = eye.camera.world_from_pixel * glm::dvec3(at, 1.0);
  if (point.one_sided && glm::dot(point.normal, place.direction) >= 0) return place;
  place.distance = h.z / point.disparity;
  place.beside = !through;
  return place;
}

std::optional<glm::u8vec3> SightLines::colorFrom(std::size_t i, const RayPoint& point) const {
  const Eye& eye = eyes_[i];
  const Place place = placeIn(eye, point);
  if (place.distance < 1.0) return std::nullopt;
  const glm::dmat3& p = eye.camera.world_from_pixel;
  const Sight sight =
      caster_.look({glm::vec3(eye.camera.center), glm::vec3(place.direction), glm::vec3(p[0]),
                    glm::vec3(p[1]), 1.0f, static_cast<float>(eye.most)});
  const bool sky = point.normal == glm::dvec3(0);
  const bool seen = sky ? sight.distance < 0
                        : std::abs(static_cast<double>(sight.distance) - place.distance) <=
                              kSameSurface * place.distance;
  return seen ? std::optional(sight.color) : std::nullopt;
}

std::optional<std::size_t> SightLines::bestEye(const RayPoint& point) const {
  if (colorFrom(0, point)) return 0;
  // By the area of the surface that a pixel covers, but for a factor that all eyes share.
  std::vector<std::pair<double, std::size_t>> eyes;
  for (std::size_t i = 1; i < eyes_.size(); ++i) {
    const Place place = placeIn(eyes_[i], point);
    if (place.distance < 1.0) continue;
    const double facing = std::abs(glm::dot(point.normal, place.direction));
    const double area = place.distance * place.distance / std::max(facing, 1e-12) *
                        imagePlaneDistance(eyes_[i].camera) *
                        (place.beside ? kDoubtBesideThePortal : 1.0);
    eyes.emplace_back(area, i);
  }
  std::sort(eyes.begin(), eyes.end());
  for (const auto& [area, i] : eyes) {
    if (colorFrom(i, point)) return i;
  }
  return std::nullopt;
}

}  // namespace enfilade
