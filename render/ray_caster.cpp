#include "render/ray_caster.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cassert>
#include <thread>

#include "render/embree_scene.h"
#include "render/packet_painter.h"
#include "render/renderer.h"
#include "render/share_out.h"
#include "render/surfaces.h"

namespace enfilade {
namespace {

constexpr int kTileSide = 32;  // [pixels]
constexpr std::size_t kRaysTogether = 4096;
constexpr float kBeyondASurface = 1.0f + 1e-6f;  // of its distance: where the next is looked for
constexpr int kMostOnARay = 256;                 // surfaces before it is given up

RTCRayHit rayHitOf(const glm::vec3& origin, const glm::vec3& direction, float least,
                   float most) noexcept {
  RTCRayHit hit{};
  hit.ray.org_x = origin.x;
  hit.ray.org_y = origin.y;
  hit.ray.org_z = origin.z;
  hit.ray.tnear = least;
  hit.ray.dir_x = direction.x;
  hit.ray.dir_y = direction.y;
  hit.ray.dir_z = direction.z;
  hit.ray.tfar = most;
  hit.ray.mask = ~0u;
  hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  hit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  return hit;
}

RayHit castOne(const EmbreeScene& scene, const Ray& ray, const RayQuery& query) noexcept {
  RTCRayHit hit = rayHitOf(ray.origin, ray.unit_direction, ray.min_distance, ray.max_distance);
  scene.intersect(hit, query);
  if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {-1.0f, kNone, kNone};
  return {hit.ray.tfar, hit.hit.geomID, hit.hit.primID};
}

/// The next surface on a ray from distance `least` on.
RTCRayHit nextOn(const EmbreeScene& scene, const PictureRay& ray, float least,
                 const RayQuery& query) noexcept {
  RTCRayHit hit = rayHitOf(ray.origin, ray.direction, least, ray.most);
  scene.intersect(hit, query);
  return hit;
}

}  // namespace

struct RayCaster::Impl {
  Impl(const Building& building, std::span<const std::uint8_t> hidden,
       std::span<const std::uint8_t> switched, int thread_count)
      : surfaces(building),
        scene(building, surfaces, hidden, switched),
        threads(thread_count > 0 ? thread_count
                                 : static_cast<int>(std::thread::hardware_concurrency())) {}

  Surfaces surfaces;
  EmbreeScene scene;
  int threads;
};

RayCaster::RayCaster(const Building& building, std::span<const std::uint8_t> hidden, int threads,
                     std::span<const std::uint8_t> switched)
    : impl_(std::make_unique<Impl>(building, hidden, switched, threads)) {}

void RayCaster::setHidden(std::span<const std::uint8_t> hidden) { impl_->scene.setHidden(hidden); }

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
  const RayQuery query{through_blended, glm::vec3(0), glm::vec3(0), false};
  return castOne(impl_->scene, {origin, unit_direction, min_distance, max_distance}, query);
}

void RayCaster::cast(std::span<const Ray> rays, bool through_blended,
                     std::span<RayHit> hits) const {
  assert(rays.size() == hits.size());
  const RayQuery query{through_blended, glm::vec3(0), glm::vec3(0), false};
  const auto castSome = [&](std::size_t part) {
    const std::size_t end = std::min((part + 1) * kRaysTogether, rays.size());
    for (std::size_t i = part * kRaysTogether; i < end; ++i) {
      hits[i] = castOne(impl_->scene, rays[i], query);
    }
  };
  shareOut((rays.size() + kRaysTogether - 1) / kRaysTogether, impl_->threads, castSome);
}

Sight RayCaster::look(const PictureRay& ray) const noexcept {
  const RayQuery query{false, ray.right, ray.down, false};
  Sight sight;
  glm::vec3 color = glm::vec3(kSkyColor[0], kSkyColor[1], kSkyColor[2]) / 255.0f;
  glm::vec3 layers(0);  // blended material so far
  float left = 1.0f;    // what shows through it
  float least = ray.least;
  for (int layer = 0; layer < kMostOnARay; ++layer) {
    const RTCRayHit hit = nextOn(impl_->scene, ray, least, query);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
    const SurfaceTriangle met = impl_->surfaces.triangle(hit.hit.geomID, hit.hit.primID);
    const glm::vec4 shade = impl_->surfaces.color(
        met, hit.hit.u, hit.hit.v, {ray.direction, ray.right, ray.down}, hit.ray.tfar);
    if (impl_->surfaces.material(met.object).alpha_mode != AlphaMode::kBlend) {
      sight.distance = hit.ray.tfar;
      color = glm::vec3(shade);
      break;
    }
    layers += left * shade.a * glm::vec3(shade);
    left *= 1.0f - shade.a;
    least = hit.ray.tfar * kBeyondASurface;
  }
  sight.color = glm::u8vec3(glm::min(layers + left * color, 1.0f) * 255.0f + 0.5f);
  return sight;
}

void RayCaster::surfacesOn(const PictureRay& ray, std::vector<SurfaceOnRay>& surfaces) const {
  const RayQuery query{true, ray.right, ray.down, true};
  float least = ray.least;
  for (int layer = 0; layer < kMostOnARay; ++layer) {
    const RTCRayHit hit = nextOn(impl_->scene, ray, least, query);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return;
    surfaces.push_back({hit.ray.tfar, hit.hit.geomID,
                        glm::vec3(hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z),
                        !impl_->surfaces.material(hit.hit.geomID).double_sided});
    least = hit.ray.tfar * kBeyondASurface;
  }
}

}  // namespace enfilade
