#include "render/light_rays.h"

#include <embree3/rtcore.h>

#include "render/embree_world.h"

namespace enfilade {
namespace {

struct Context {
  RTCIntersectContext embree;  // first: Embree hands back a pointer to it
  float chance = 1;
  bool screens = false;
  bool tints = false;  // blended material is passed, and dims
  glm::vec3 passed{1};
};

Context contextOf(float chance, bool screens, bool tints) {
  Context context;
  rtcInitIntersectContext(&context.embree);
  context.chance = chance;
  context.screens = screens;
  context.tints = tints;
  return context;
}

RTCRay rayOf(const glm::vec3& origin, const glm::vec3& direction, float least, float most) {
  RTCRay ray{};
  ray.org_x = origin.x;
  ray.org_y = origin.y;
  ray.org_z = origin.z;
  ray.dir_x = direction.x;
  ray.dir_y = direction.y;
  ray.dir_z = direction.z;
  ray.tnear = least;
  ray.tfar = most;
  ray.mask = ~0u;
  return ray;
}

}  // namespace

struct LightRays::Impl {
  struct Filtered {
    const Impl* owner;
    std::uint32_t object;
  };

  Impl(const Building& building, std::span<const std::uint8_t> clear,
       std::span<const OneWayScreen> screens);

  void addObject(std::uint32_t object);
  void addScreens(std::span<const OneWayScreen> screens);
  glm::vec4 colorAt(std::uint32_t object, unsigned int triangle, float u, float v) const {
    const SurfaceTriangle met = surfaces.triangle(object, triangle);
    return surfaces.color(met, u, v, {-met.normal, glm::vec3(0), glm::vec3(0)}, 1);
  }
  static void filterSurface(const RTCFilterFunctionNArguments* a);
  static void filterScreen(const RTCFilterFunctionNArguments* a);

  Surfaces surfaces;
  EmbreeWorld embree;
  std::vector<Filtered> filtered;  // at addresses that Embree keeps
  std::vector<glm::vec3> screen_corners;
  std::vector<std::uint32_t> screen_triangles;
  bool glass = false;
};

LightRays::Impl::Impl(const Building& building, std::span<const std::uint8_t> clear,
                      std::span<const OneWayScreen> screens)
    : surfaces(building) {
  filtered.resize(building.objects.size());
  for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
    filtered[o] = {this, o};
    const bool is_clear = o < clear.size() && clear[o] != 0;
    if (!is_clear && surfaces.world().objects[o].count > 0) addObject(o);
  }
  addScreens(screens);
  embree.commit();
}

void LightRays::Impl::addObject(std::uint32_t object) {
  RTCGeometry geometry = embree.objectGeometry(surfaces.world(), object);
  const AlphaMode alpha = surfaces.material(object).alpha_mode;
  glass = glass || alpha == AlphaMode::kBlend;
  if (alpha != AlphaMode::kOpaque) {
    rtcSetGeometryUserData(geometry, &filtered[object]);
    rtcSetGeometryIntersectFilterFunction(geometry, &filterSurface);
    rtcSetGeometryOccludedFilterFunction(geometry, &filterSurface);
  }
  embree.attach(geometry, object);
}

void LightRays::Impl::addScreens(std::span<const OneWayScreen> screens) {
  for (const OneWayScreen& screen : screens) {
    // Wound so that the geometric normal is the screen's.
    const auto& p = screen.polygon;
    const auto first = static_cast<std::uint32_t>(screen_corners.size());
    screen_corners.insert(screen_corners.end(), p.begin(), p.end());
    for (std::uint32_t i = 1; i + 1 < p.size(); ++i) {
      const bool same = glm::dot(glm::cross(p[i] - p[0], p[i + 1] - p[0]), screen.normal) > 0;
      screen_triangles.insert(screen_triangles.end(),
                              {first, first + (same ? i : i + 1), first + (same ? i + 1 : i)});
    }
  }
  if (screen_triangles.empty()) return;
  screen_corners.emplace_back(0);  // Embree reads 16 bytes for the last corner
  RTCGeometry geometry = rtcNewGeometry(embree.device(), RTC_GEOMETRY_TYPE_TRIANGLE);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                             screen_corners.data(), 0, sizeof(glm::vec3),
                             screen_corners.size() - 1);
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                             screen_triangles.data(), 0, 3 * sizeof(std::uint32_t),
                             screen_triangles.size() / 3);
  rtcSetGeometryIntersectFilterFunction(geometry, &filterScreen);
  rtcSetGeometryOccludedFilterFunction(geometry, &filterScreen);
  embree.attach(geometry, static_cast<std::uint32_t>(filtered.size()));
}

void LightRays::Impl::filterSurface(const RTCFilterFunctionNArguments* a) {
  const auto& [owner, object] = *static_cast<const Filtered*>(a->geometryUserPtr);
  Context& context = *reinterpret_cast<Context*>(a->context);
  const Material& material = owner->surfaces.material(object);
  const unsigned int n = a->N;
  for (unsigned int i = 0; i < n; ++i) {
    if (a->valid[i] != -1) continue;
    const glm::vec4 color = owner->colorAt(object, RTCHitN_primID(a->hit, n, i),
                                           RTCHitN_u(a->hit, n, i), RTCHitN_v(a->hit, n, i));
    if (material.alpha_mode == AlphaMode::kMask) {
      if (color.a < material.alpha_cutoff) a->valid[i] = 0;
    } else if (context.tints) {
      const glm::vec3 linear = glm::pow(glm::max(glm::vec3(color), 0.0f), glm::vec3(2.2f));
      context.passed *= (1 - color.a) * glm::mix(glm::vec3(1), linear, color.a);
      a->valid[i] = 0;
    } else if (color.a <= context.chance) {
      a->valid[i] = 0;
    }
  }
}

void LightRays::Impl::filterScreen(const RTCFilterFunctionNArguments* a) {
  const Context& context = *reinterpret_cast<const Context*>(a->context);
  const unsigned int n = a->N;
  for (unsigned int i = 0; i < n; ++i) {
    if (a->valid[i] != -1) continue;
    const glm::vec3 direction(RTCRayN_dir_x(a->ray, n, i), RTCRayN_dir_y(a->ray, n, i),
                              RTCRayN_dir_z(a->ray, n, i));
    const glm::vec3 normal(RTCHitN_Ng_x(a->hit, n, i), RTCHitN_Ng_y(a->hit, n, i),
                           RTCHitN_Ng_z(a->hit, n, i));
    if (!context.screens || glm::dot(normal, direction) >= 0) a->valid[i] = 0;
  }
}

LightRays::LightRays(const Building& building, std::span<const std::uint8_t> clear,
                     std::span<const OneWayScreen> screens)
    : impl_(std::make_unique<Impl>(building, clear, screens)) {}

LightRays::~LightRays() = default;

const Surfaces& LightRays::surfaces() const noexcept { return impl_->surfaces; }
bool LightRays::hasGlass() const noexcept { return impl_->glass; }

LightHit LightRays::trace(const glm::vec3& origin, const glm::vec3& unit_direction, float least,
                          float most, float chance, bool screens) const noexcept {
  Context context = contextOf(chance, screens, false);
  RTCRayHit met{};
  met.ray = rayOf(origin, unit_direction, least, most);
  met.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  met.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(impl_->embree.scene(), &context.embree, &met);
  LightHit hit;
  if (met.hit.geomID == RTC_INVALID_GEOMETRY_ID) return hit;
  hit.distance = met.ray.tfar;
  if (met.hit.geomID == impl_->filtered.size()) return hit;
  hit.object = met.hit.geomID;
  hit.triangle = met.hit.primID;
  hit.u = met.hit.u;
  hit.v = met.hit.v;
  const glm::vec3 normal(met.hit.Ng_x, met.hit.Ng_y, met.hit.Ng_z);
  hit.back = glm::dot(normal, unit_direction) > 0;
  return hit;
}

glm::vec3 LightRays::passed(const glm::vec3& origin, const glm::vec3& unit_direction, float least,
                            float most) const noexcept {
  Context context = contextOf(1, false, true);
  RTCRay ray = rayOf(origin, unit_direction, least, most);
  rtcOccluded1(impl_->embree.scene(), &context.embree, &ray);
  return ray.tfar < 0 ? glm::vec3(0) : context.passed;
}

}  // namespace enfilade
