#pragma once

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "render/texture_sampler.h"
#include "render/world_geometry.h"
#include "scene/building.h"

namespace enfilade {

/// A ray and those of the neighbouring pixels, which choose a texture's mip level.
struct PixelRay {
  glm::vec3 direction{0};  ///< of any length
  glm::vec3 right{0};      ///< what one pixel to the right adds to the direction; 0: finest level
  glm::vec3 down{0};       ///< one pixel down
};

/// A triangle in the world, ready to be shaded where rays meet it.
struct SurfaceTriangle {
  std::uint32_t object = kNone;
  std::uint32_t triangle = kNone;
  const WorldVertex* corners[3] = {};
  glm::vec3 normal{0};  ///< not unit; towards the front
  bool flat = false;    ///< the corners' colours are the same: `front` and `back`
  glm::vec4 front{0};   ///< RGBA 0…1, the first corner's
  glm::vec4 back{0};
  glm::vec3 gradient_s{0};  ///< of the texture coordinates over the plane [1/m]
  glm::vec3 gradient_t{0};
};

/// The colours of a building's surfaces, by the same formula as the renderer's shaders.
class Surfaces {
 public:
  /// Keeps a reference to `building`.
  explicit Surfaces(const Building& building);

  const WorldGeometry& world() const noexcept { return world_; }
  const Material& material(std::uint32_t object) const noexcept { return *of_[object].material; }

  SurfaceTriangle triangle(std::uint32_t object, std::uint32_t triangle) const noexcept;

  /// RGBA 0…1 at the barycentric coordinates (u, v), `distance` along `ray` [its lengths].
  glm::vec4 color(const SurfaceTriangle& triangle, float u, float v, const PixelRay& ray,
                  float distance) const noexcept;

 private:
  struct Surface {
    const Material* material = nullptr;
    const TextureSampler* texture = nullptr;  // none: the mesh is plain
  };

  WorldGeometry world_;
  std::vector<std::unique_ptr<TextureSampler>> textures_;  // one an image
  std::vector<Surface> of_;                                // one an object
};

}  // namespace enfilade
