#include "render/ray_caster.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <thread>

#include "render/embree_scene.h"
#include "render/packet_painter.h"
#include "render/share_out.h"
#include "render/surfaces.h"

namespace enfilade {
namespace {

constexpr int kTileSide = 32;  // [pixels]
constexpr std::size_t kRaysTogether = 4096;

RTCRayHit rayHitOf(const Ray& ray) noexcept {
  RTCRayHit hit{};
  hit.ray.org_x = ray.origin.x;
  hit.ray.org_y = ray.origin.y;
  hit.ray.org_z = ray.origin.z;
  hit.ray.tnear = ray.min_distance;
  hit.ray.dir_x = ray.unit_direction.x;
  hit.ray.dir_y = ray.unit_direction.y;
  hit.ray.dir_z = ray.unit_direction.z;
  hit.ray.tfar = ray.max_distance;
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return hit;
}

RayHit castOne(const EmbreeScene& scene, const Ray& ray, const RayQuery& query) noexcept {
  RTCRayHit hit = rayHitOf(ray);
  scene.intersect(hit, query);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {-1.0f, kNone, kNone};
  return {hit.ray.tfar, hit.hit.geomID, hit.hit.primID};
}

}  // namespace

struct RayCaster::Impl {
  Impl(const Building& building, std::span<const std::uint8_t> hidden, int thread_count)
      : surfaces(building),
        scene(building, surfaces, hidden),
        threads(thread_count > 0 ? thread_count
                                 : static_cast<int>(std::thread::hardware_concurrency())) {}

  Surfaces surfaces;
  EmbreeScene scene;
  int threads;
};

RayCaster::RayCaster(const Building& building, std::span<const std::uint8_t> hidden, int threads)
    : impl_(std::make_unique<Impl>(building, hidden, threads)) {}

RayCaster::~RayCaster() = default;

void RayCaster::render(const Camera& camera, int width, int height, Image& out) const {
  out.width = width;
  out.height = height;
  out.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const PixelRays rays = pixelRays(camera, width, height);
  const int columns = (width + kTileSide - 1) / kTileSide;
  const int rows = (height + kTileSide - 1) / kTileSide;
  const auto paintTile = [&](std::size_t tile) {
    const int left = static_cast<int>(tile) % columns * kTileSide;
    const int top = static_cast<int>(tile) / columns * kTileSide;
    PacketPainter painter(impl_->scene, impl_->surfaces, rays, out);
    for (int y = top; y < std::min(top + kTileSide, height); y += kPacketSide) {
      for (int x = left; x < std::min(left + kTileSide, width); x += kPacketSide) {
        painter.paint(x, y);
      }
    }
  };
  shareOut(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), impl_->threads,
           paintTile);
}

RayHit RayCaster::cast(const glm::vec3& origin, const glm::vec3& unit_direction, float min_distance,
                       float max_distance, bool through_blended) const {
  const RayQuery query{through_blended, glm::vec3(0), glm::vec3(0)};
  return castOne(impl_->scene, {origin, unit_direction, min_distance, max_distance}, query);
}

void RayCaster::cast(std::span<const Ray> rays, bool through_blended,
                     std::span<RayHit> hits) const {
  assert(rays.size() == hits.size());
  const RayQuery query{through_blended, glm::vec3(0), glm::vec3(0)};
  const auto castSome = [&](std::size_t part) {
    const std::size_t end = std::min((part + 1) * kRaysTogether, rays.size());
    for (std::size_t i = part * kRaysTogether; i < end; ++i) {
      hits[i] = castOne(impl_->scene, rays[i], query);
    }
  };
  shareOut((rays.size() + kRaysTogether - 1) / kRaysTogether, impl_->threads, castSome);
}

}  // namespace enfilade
