#include "render/embree_scene.h"

#include <embree3/rtcore.h>

namespace enfilade {
namespace {

struct Context {
  RTCIntersectContext embree;  // first: Embree hands back a pointer to it
  const RayQuery* query;
};

Context contextOf(const RayQuery& query, bool coherent) {
  Context context;
  rtcInitIntersectContext(&context.embree);
  if (coherent) context.embree.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  context.query = &query;
  return context;
}

bool needsFilter(const Material& material) {
  return !material.double_sided || material.alpha_mode != AlphaMode::kOpaque;
}

}  // namespace

struct EmbreeScene::Filter {
  /// Whether the ray goes on through the surface that it met.
  static bool passes(const Filtered& filtered, const RayQuery& query, unsigned int triangle,
                     float u, float v, const glm::vec3& direction, const glm::vec3& normal,
                     float distance) {
    if (filtered.hidden) return true;
    const Material& material = filtered.surfaces->material(filtered.object);
    const bool one_sided = !material.double_sided && !query.meets_backs;
    if (one_sided && glm::dot(normal, direction) > 0.0f) return true;
    if (material.alpha_mode == AlphaMode::kBlend) return query.through_blended;
    if (material.alpha_mode != AlphaMode::kMask) return false;
    const Surfaces& surfaces = *filtered.surfaces;
    const PixelRay ray{direction, query.right, query.down};
    const SurfaceTriangle met = surfaces.triangle(filtered.object, triangle);
    return surfaces.color(met, u, v, ray, distance).a < material.alpha_cutoff;
  }

  static void run(const RTCFilterFunctionNArguments* a) {
    const auto& filtered = *static_cast<const Filtered*>(a->geometryUserPtr);
    const RayQuery& query = *reinterpret_cast<const Context*>(a->context)->query;
    const unsigned int n = a->N;
    for (unsigned int i = 0; i < n; ++i) {
      if (a->valid[i] != -1) continue;
      const glm::vec3 direction(RTCRayN_dir_x(a->ray, n, i), RTCRayN_dir_y(a->ray, n, i),
                                RTCRayN_dir_z(a->ray, n, i));
      const glm::vec3 normal(RTCHitN_Ng_x(a->hit, n, i), RTCHitN_Ng_y(a->hit, n, i),
                             RTCHitN_Ng_z(a->hit, n, i));
      if (passes(filtered, query, RTCHitN_primID(a->hit, n, i), RTCHitN_u(a->hit, n, i),
                 RTCHitN_v(a->hit, n, i), direction, normal, RTCRayN_tfar(a->ray, n, i))) {
        a->valid[i] = 0;
      }
    }
  }
};

EmbreeScene::EmbreeScene(const Building& building, const Surfaces& surfaces,
                         std::span<const std::uint8_t> hidden,
                         std::span<const std::uint8_t> switched)
    : surfaces_(surfaces) {
  filtered_.resize(building.objects.size());
  for (std::uint32_t o = 0; o < building.objects.size(); ++o) {
    const bool is_switched = o < switched.size() && switched[o] != 0;
    const bool is_hidden = o < hidden.size() && hidden[o] != 0;
    filtered_[o] = {&surfaces_, o, is_switched, is_hidden};
    if (is_hidden && !is_switched) continue;
    if (surfaces_.world().objects[o].count == 0) continue;
    addObject(o, is_switched || needsFilter(surfaces_.material(o)));
  }
  embree_.commit();
}

void EmbreeScene::setHidden(std::span<const std::uint8_t> hidden) noexcept {
  for (Filtered& filtered : filtered_) {
    if (filtered.switched) filtered.hidden = hidden[filtered.object] != 0;
  }
}

void EmbreeScene::addObject(std::uint32_t object, bool filtered) {
  RTCGeometry geometry = embree_.objectGeometry(surfaces_.world(), object);
  if (filtered) {
    rtcSetGeometryUserData(geometry, &filtered_[object]);
    rtcSetGeometryIntersectFilterFunction(geometry, &Filter::run);
  }
  embree_.attach(geometry, object);
}

void EmbreeScene::intersect(const int* valid, RTCRayHit16& rays, const RayQuery& query,
                            bool coherent) const noexcept {
  Context context = contextOf(query, coherent);
  rtcIntersect16(valid, embree_.scene(), &context.embree, &rays);
}

void EmbreeScene::intersect(RTCRayHit& ray, const RayQuery& query) const noexcept {
  Context context = contextOf(query, false);
  rtcIntersect1(embree_.scene(), &context.embree, &ray);
}

}  // namespace enfilade
