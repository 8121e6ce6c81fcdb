#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/embree_world.h"
#include "render/surfaces.h"

struct RTCRayHit;
struct RTCRayHit16;

namespace enfilade {

/// What a query passes besides the back faces of single-sided material and masked-out texels.
struct RayQuery {
  bool through_blended = false;
  glm::vec3 right{0};  ///< as in PixelRay
  glm::vec3 down{0};
  bool meets_backs = false;  ///< back faces of single-sided material are not passed
};

/// Embree's view of a building: one geometry an object, whose number is the object's.
class EmbreeScene {
 public:
  /// `hidden`, `switched`: see RayCaster.  Keeps references to both.  Throws Error (kMachine).
  EmbreeScene(const Building& building, const Surfaces& surfaces,
              std::span<const std::uint8_t> hidden, std::span<const std::uint8_t> switched);
  EmbreeScene(const EmbreeScene&) = delete;
  EmbreeScene& operator=(const EmbreeScene&) = delete;

  /// Hides or shows switched objects, while no ray is on its way.
  void setHidden(std::span<const std::uint8_t> hidden) noexcept;

  /// `valid`: −1 for the rays to trace, aligned to 64 bytes.  Thread-safe.
  void intersect(const int* valid, RTCRayHit16& rays, const RayQuery& query,
                 bool coherent) const noexcept;
  void intersect(RTCRayHit& ray, const RayQuery& query) const noexcept;

 private:
  struct Filtered {
    const Surfaces* surfaces;
    std::uint32_t object;
    bool switched, hidden;
  };
  struct Filter;

  void addObject(std::uint32_t object, bool filtered);

  EmbreeWorld embree_;
  const Surfaces& surfaces_;
  std::vector<Filtered> filtered_;  // one an object, at addresses that Embree keeps
};

}  // namespace enfilade
