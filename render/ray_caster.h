#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <vector>

#include "scene/building.h"
#include "scene/camera.h"
#include "scene/image.h"

namespace enfilade {

/// A ray between two distances from its origin.
struct Ray {
  glm::vec3 origin{0};  ///< world [m]
  glm::vec3 unit_direction{0, 0, -1};
  float min_distance = 0;  ///< [m]
  float max_distance = 0;  ///< [m]
};

/// What a ray met.
struct RayHit {
  float distance = 0;              ///< [m] along the unit direction; < 0: nothing
  std::uint32_t object = kNone;    ///< index in Building::objects
  std::uint32_t triangle = kNone;  ///< of the object's mesh
};

/// A ray of a picture.  Distances along it count in lengths of its direction.
struct PictureRay {
  glm::vec3 origin{0};            ///< world [m]
  glm::vec3 direction{0, 0, -1};  ///< [m] of any length
  glm::vec3 right{0};             ///< what one pixel to the right adds to the direction
  glm::vec3 down{0};              ///< one pixel down
  float least = 0, most = 0;      ///< distances
};

/// What a ray of a picture shows.
struct Sight {
  float distance = -1;   ///< of the first surface that is not blended; < 0: none, the sky
  glm::u8vec3 color{0};  ///< sRGB; blended material over what lies behind it
};

/// A surface on a ray, hidden or not.
struct SurfaceOnRay {
  float distance = 0;
  std::uint32_t object = kNone;  ///< index in Building::objects
  glm::vec3 normal{0};           ///< not unit; towards its front
  bool one_sided = false;        ///< it is seen from its front only
};

/// Primary rays through a building by Embree, shaded like the renderer (textures trilinear, masks
/// tested, blended material blended): what a user without a GPU would pick today.  The same pixels
/// for any number of threads.  Where surfaces coincide any one of them is met, the same in every
/// run.
class RayCaster {
 public:
  /// `hidden`: one flag an object (not 0: hidden), or empty; hidden objects are not there (doors
  /// while walking).  `switched`, likewise: which objects setHidden() may hide and show; it costs
  /// rays that meet them.  `threads` 0: as many as the machine has.  Keeps a reference to
  /// `building`.  Throws Error (kMachine).
  RayCaster(const Building& building, std::span<const std::uint8_t> hidden, int threads,
            std::span<const std::uint8_t> switched = {});
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  /// Hides or shows switched objects, `hidden` one flag an object, while no ray is on its way.
  void setHidden(std::span<const std::uint8_t> hidden);

  /// A picture of `width` × `height` rays through the pixel centres; the sky where nothing is met.
  void render(const Camera& camera, int width, int height, Image& out) const;

  /// The first surface that a ray meets within `max_distance` beyond `min_distance`.  Masked-out
  /// texels (of the texture's finest level) and, when `through_blended`, blended material are
  /// passed.  Back faces of single-sided material are passed, as they are not drawn.  Thread-safe.
  RayHit cast(const glm::vec3& origin, const glm::vec3& unit_direction, float min_distance,
              float max_distance, bool through_blended) const;

  /// The same for many rays at once, on all threads: hits[i] is what rays[i] met.  Rays that start
  /// near each other in about one direction are best kept together.
  void cast(std::span<const Ray> rays, bool through_blended, std::span<RayHit> hits) const;

  /// What a pixel of a picture shows, as render() paints it.  Thread-safe.
  Sight look(const PictureRay& ray) const noexcept;

  /// Appends every surface on the ray, nearest first, whichever side is met, but masked-out texels
  /// and blended material.  Of surfaces within a millionth of their distance one is named.
  /// Thread-safe.
  void surfacesOn(const PictureRay& ray, std::vector<SurfaceOnRay>& surfaces) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace enfilade
