#pragma once

#include <glm/glm.hpp>
#include <memory>

#include "render/embree_scene.h"
#include "render/surfaces.h"
#include "scene/camera.h"
#include "scene/image.h"

namespace enfilade {

/// The rays of a camera's pixels: origin + t · (corner + x · right + y · down) at pixel (x, y), row
/// 0 on top, where t is the distance along the camera's axis [m], as in a depth buffer.
struct PixelRays {
  glm::vec3 origin;
  glm::vec3 corner;
  glm::vec3 right;
  glm::vec3 down;
  float near_plane;
  float far_plane;
};

PixelRays pixelRays(const Camera& camera, int width, int height);

/// The side of the square of pixels whose rays are traced together.
inline constexpr int kPacketSide = 4;

/// Paints packets of one picture, on one thread.
class PacketPainter {
 public:
  /// Keeps references to all.
  PacketPainter(const EmbreeScene& scene, const Surfaces& surfaces, const PixelRays& rays,
                Image& out) noexcept;
  ~PacketPainter();
  PacketPainter(const PacketPainter&) = delete;
  PacketPainter& operator=(const PacketPainter&) = delete;

  /// Paints the packet whose first pixel is (x, y): blended material over what lies behind it, the
  /// sky where nothing is met.  Pixels outside the picture are left out.
  void paint(int x, int y) noexcept;

 private:
  struct Packet;
  std::unique_ptr<Packet> packet_;
};

}  // namespace enfilade
