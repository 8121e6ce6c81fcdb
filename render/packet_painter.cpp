#include "render/packet_painter.h"

#include <embree3/rtcore.h>

#include <cmath>

#include "render/renderer.h"

namespace enfilade {
namespace {

constexpr int kLanes = kPacketSide * kPacketSide;
constexpr int kMostLayers = 64;  // of blended material before a ray is given up
const glm::vec4 kSky = glm::vec4(kSkyColor[0], kSkyColor[1], kSkyColor[2], kSkyColor[3]) / 255.0f;

}  // namespace

struct PacketPainter::Packet {
  Packet(const EmbreeScene& embree_scene, const Surfaces& all_surfaces, const PixelRays& pixel_rays,
         Image& picture) noexcept
      : scene(embree_scene), surfaces(all_surfaces), rays(pixel_rays), out(picture) {
    for (int lane = 0; lane < kLanes; ++lane) {
      hits.ray.org_x[lane] = rays.origin.x;
      hits.ray.org_y[lane] = rays.origin.y;
      hits.ray.org_z[lane] = rays.origin.z;
      hits.ray.time[lane] = 0;
      hits.ray.mask[lane] = ~0u;
      hits.ray.id[lane] = 0;
      hits.ray.flags[lane] = 0;
    }
  }

  void start(int x, int y) noexcept {
    corner_x = x;
    corner_y = y;
    for (int lane = 0; lane < kLanes; ++lane) {
      const glm::vec3 d = directionOf(lane);
      valid[lane] = columnOf(lane) < out.width && rowOf(lane) < out.height ? -1 : 0;
      hits.ray.dir_x[lane] = d.x;
      hits.ray.dir_y[lane] = d.y;
      hits.ray.dir_z[lane] = d.z;
      layers[lane] = glm::vec3(0);
      left[lane] = 1.0f;
      restart(lane, rays.near_plane);
    }
  }

  void trace() noexcept {
    const RayQuery query{false, rays.right, rays.down, false};
    bool more = true;
    for (int layer = 0; more && layer < kMostLayers; ++layer) {
      scene.intersect(valid, hits, query, true);
      more = false;
      for (int lane = 0; lane < kLanes; ++lane) {
        if (valid[lane] == 0) continue;
        if (!meet(lane)) valid[lane] = 0;
        more = more || valid[lane] != 0;
      }
    }
    for (int lane = 0; lane < kLanes; ++lane) {
      if (valid[lane] != 0) store(lane, kSky);  // given up
    }
  }

  int columnOf(int lane) const noexcept { return corner_x + lane % kPacketSide; }
  int rowOf(int lane) const noexcept { return corner_y + lane / kPacketSide; }

  glm::vec3 directionOf(int lane) const noexcept {
    return rays.corner + (static_cast<float>(columnOf(lane)) + 0.5f) * rays.right +
           (static_cast<float>(rowOf(lane)) + 0.5f) * rays.down;
  }

  void restart(int lane, float from) noexcept {
    hits.ray.tnear[lane] = from;
    hits.ray.tfar[lane] = rays.far_plane;
    hits.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    hits.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
  }

  /// Adds what the ray met to its pixel; true if it goes on behind it.
  bool meet(int lane) noexcept {
    const std::uint32_t object = hits.hit.geomID[lane];
    if (object == RTC_INVALID_GEOMETRY_ID) {
      store(lane, kSky);
      return false;
    }
    const std::uint32_t triangle = hits.hit.primID[lane];
    if (met.object != object || met.triangle != triangle) {
      met = surfaces.triangle(object, triangle);
    }
    const float distance = hits.ray.tfar[lane];
    const glm::vec3 d(hits.ray.dir_x[lane], hits.ray.dir_y[lane], hits.ray.dir_z[lane]);
    const glm::vec4 color = surfaces.color(met, hits.hit.u[lane], hits.hit.v[lane],
                                           {d, rays.right, rays.down}, distance);
    if (surfaces.material(object).alpha_mode != AlphaMode::kBlend) {
      store(lane, color);
      return false;
    }
    layers[lane] += left[lane] * color.a * glm::vec3(color);
    left[lane] *= 1.0f - color.a;
    restart(lane, distance * (1.0f + 1e-6f));
    return true;
  }

  void store(int lane, const glm::vec4& color) noexcept {
    const glm::vec3 c =
        glm::min(layers[lane] + left[lane] * glm::vec3(color), 1.0f) * 255.0f + 0.5f;
    std::uint8_t* p =
        &out.rgba[4 * (static_cast<std::size_t>(rowOf(lane)) * static_cast<std::size_t>(out.width) +
                       static_cast<std::size_t>(columnOf(lane)))];
    for (int k = 0; k < 3; ++k) p[k] = static_cast<std::uint8_t>(c[k]);
    p[3] = 255;
  }

  const EmbreeScene& scene;
  const Surfaces& surfaces;
  const PixelRays& rays;
  Image& out;
  int corner_x = 0;  // of the packet at hand
  int corner_y = 0;
  alignas(64) RTCRayHit16 hits;
  alignas(64) int valid[kLanes];
  glm::vec3 layers[kLanes];  // blended material so far
  float left[kLanes];        // what shows through it
  SurfaceTriangle met;       // the last; neighbours mostly meet the same
};

PacketPainter::PacketPainter(const EmbreeScene& scene, const Surfaces& surfaces,
                             const PixelRays& rays, Image& out) noexcept
    : packet_(std::make_unique<Packet>(scene, surfaces, rays, out)) {}

PacketPainter::~PacketPainter() = default;

void PacketPainter::paint(int x, int y) noexcept {
  packet_->start(x, y);
  packet_->trace();
}

PixelRays pixelRays(const Camera& camera, int width, int height) {
  const glm::mat4 world_from_camera = camera.worldFromCamera();
  const float half_height = std::tan(0.5f * camera.vertical_fov);
  const float half_width = half_height * camera.aspect;
  const glm::vec3 x(world_from_camera[0]);
  const glm::vec3 y(world_from_camera[1]);
  const glm::vec3 z(world_from_camera[2]);
  PixelRays rays;
  rays.origin = camera.pose.position;
  rays.corner = -z - half_width * x + half_height * y;
  rays.right = x * (2.0f * half_width / static_cast<float>(width));
  rays.down = -y * (2.0f * half_height / static_cast<float>(height));
  rays.near_plane = camera.near_plane;
  rays.far_plane = camera.far_plane;
  return rays;
}

}  // namespace enfilade
