#include "render/surfaces.h"

#include <cmath>

namespace enfilade {
namespace {

glm::vec4 tintAt(const SurfaceTriangle& t, bool front, float u, float v) noexcept {
  const auto side = [&](int k) {
    return glm::vec4(front ? t.corners[k]->front : t.corners[k]->back);
  };
  return ((1.0f - u - v) * side(0) + u * side(1) + v * side(2)) * (1.0f / 255.0f);
}

glm::vec2 texcoordAt(const SurfaceTriangle& t, float u, float v) noexcept {
  return (1.0f - u - v) * t.corners[0]->texcoord + u * t.corners[1]->texcoord +
         v * t.corners[2]->texcoord;
}

/// log2 of the longer side, in texels, of what the pixel covers of the texture: the derivatives
/// that a rasteriser takes from neighbouring pixels, exactly.
float levelOfDetail(const SurfaceTriangle& t, const PixelRay& ray, float distance,
                    const glm::vec2& size) noexcept {
  const float facing = glm::dot(t.normal, ray.direction);
  const auto squared = [&](const glm::vec3& step) {
    const glm::vec3 on_plane =
        distance * (step - ray.direction * (glm::dot(t.normal, step) / facing));
    const glm::vec2 texels =
        size * glm::vec2(glm::dot(t.gradient_s, on_plane), glm::dot(t.gradient_t, on_plane));
    return glm::dot(texels, texels);
  };
  const float longest = std::max(squared(ray.right), squared(ray.down));
  return longest > 1.0f ? 0.5f * std::log2(longest) : 0.0f;  // larger than a texel: mostly
}

}  // namespace

Surfaces::Surfaces(const Building& building) : world_(worldGeometry(building)) {
  textures_.resize(building.images.size());
  for (const Object& object : building.objects) {
    const Material& material = building.materialOf(object);
    const VertexArrays& vertices = building.vertex_arrays[building.meshOf(object).vertices];
    Surface surface{&material, nullptr};
    if (material.image != kNone && !vertices.texcoords.empty()) {
      auto& texture = textures_[material.image];
      if (!texture) {
        texture = std::make_unique<TextureSampler>(building.images[material.image].image);
      }
      surface.texture = texture.get();
    }
    of_.push_back(surface);
  }
}

SurfaceTriangle Surfaces::triangle(std::uint32_t object, std::uint32_t triangle) const noexcept {
  SurfaceTriangle t;
  t.object = object;
  t.triangle = triangle;
  const std::size_t first = world_.objects[object].first + 3 * std::size_t{triangle};
  for (std::size_t k = 0; k < 3; ++k) {
    t.corners[k] = &world_.vertices[world_.indices[first + k]];
  }
  const glm::vec3 e1 = t.corners[1]->position - t.corners[0]->position;
  const glm::vec3 e2 = t.corners[2]->position - t.corners[0]->position;
  t.normal = glm::cross(e1, e2);
  const WorldVertex& first_corner = *t.corners[0];
  t.flat = true;
  for (const WorldVertex* corner : {t.corners[1], t.corners[2]}) {
    t.flat = t.flat && corner->front == first_corner.front && corner->back == first_corner.back;
  }
  t.front = glm::vec4(first_corner.front) * (1.0f / 255.0f);
  t.back = glm::vec4(first_corner.back) * (1.0f / 255.0f);
  if (of_[object].texture != nullptr) {
    // How fast the barycentric coordinates grow along the plane.
    const float area2 = glm::dot(t.normal, t.normal);
    const glm::vec3 gradient_u = glm::cross(e2, t.normal) / area2;
    const glm::vec3 gradient_v = glm::cross(t.normal, e1) / area2;
    const glm::vec2 along1 = t.corners[1]->texcoord - t.corners[0]->texcoord;
    const glm::vec2 along2 = t.corners[2]->texcoord - t.corners[0]->texcoord;
    t.gradient_s = gradient_u * along1.s + gradient_v * along2.s;
    t.gradient_t = gradient_u * along1.t + gradient_v * along2.t;
  }
  return t;
}

glm::vec4 Surfaces::color(const SurfaceTriangle& t, float u, float v, const PixelRay& ray,
                          float distance) const noexcept {
  const bool front = glm::dot(t.normal, ray.direction) < 0.0f;
  const glm::vec4 tint = t.flat ? (front ? t.front : t.back) : tintAt(t, front, u, v);
  const Surface& surface = of_[t.object];
  if (surface.texture == nullptr) return tint;
  const float level = levelOfDetail(t, ray, distance, surface.texture->size());
  return tint * (1.0f / 255.0f) *
         surface.texture->sample(*surface.material, texcoordAt(t, u, v), level);
}

}  // namespace enfilade
