#include "render/ray_caster.h"

#include <embree3/rtcore.h>
#include <tbb/blocked_range2d.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cassert>

#include "render/embree_scene.h"
#include "render/packet_painter.h"
#include "render/surfaces.h"
#include "scene/error.h"

namespace enfilade {
namespace {

constexpr int kTileSide = 32;  // [pixels]

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
  Impl(const Building& building, std::span<const std::uint8_t> hidden, int threads)
      : surfaces(building), scene(building, surfaces, hidden), arena(arenaSize(threads)) {}

  static int arenaSize(int threads) {
    const int most = tbb::info::default_concurrency();
    return threads > 0 ? std::min(threads, most) : most;
  }

  Surfaces surfaces;
  EmbreeScene scene;
  mutable tbb::task_arena arena;
};

RayCaster::RayCaster(const Building& building, std::span<const std::uint8_t> hidden, int threads)
    : impl_(std::make_unique<Impl>(building, hidden, threads)) {}

RayCaster::~RayCaster() = default;

void RayCaster::render(const Camera& camera, int width, int height, Image& out) const {
  out.width = width;
  out.height = height;
  out.rgba.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  const PixelRays rays = pixelRays(camera, width, height);
  const auto paintTiles = [&](const tbb::blocked_range2d<int>& tiles) {
    PacketPainter painter(impl_->scene, impl_->surfaces, rays, out);
    for (int y = tiles.rows().begin() * kTileSide;
         y < std::min(tiles.rows().end() * kTileSide, height); y += kPacketSide) {
      for (int x = tiles.cols().begin() * kTileSide;
           x < std::min(tiles.cols().end() * kTileSide, width); x += kPacketSide) {
        painter.paint(x, y);
      }
    }
  };
  const tbb::blocked_range2d<int> tiles(0, (height + kTileSide - 1) / kTileSide, 1, 0,
                                        (width + kTileSide - 1) / kTileSide, 1);
  impl_->arena.execute([&] { tbb::parallel_for(tiles, paintTiles); });
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
  impl_->arena.execute([&] {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, rays.size(), 1024),
                      [&](const tbb::blocked_range<std::size_t>& range) {
                        for (std::size_t i = range.begin(); i < range.end(); ++i) {
                          hits[i] = castOne(impl_->scene, rays[i], query);
                        }
                      });
  });
}

}  // namespace enfilade
