#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <numeric>
#include <string_view>
#include <vector>

#include "render/renderer.h"
#include "scene/building.h"

namespace enfilade::test {

/// The process's one context, on two threads: OSMesa's, or EGL's with ENFILADE_TEST_GL=egl.
inline GlContext& sharedContext() {
  const char* asked = std::getenv("ENFILADE_TEST_GL");
  const bool egl = asked != nullptr && std::string_view(asked) == "egl";
  static const std::unique_ptr<GlContext> context =
      createGlContext(egl ? GlBackend::kEgl : GlBackend::kOsMesa, 2);
  return *context;
}

inline Material unlitMaterial(const glm::vec4& base_color) {
  Material material;
  material.base_color = base_color;
  material.unlit = true;
  return material;
}

/// A quad with corners counter-clockwise as seen from its front, texture coordinates (0, 1), (1,
/// 1), (1, 0), (0, 0): with the first corner at the bottom left the picture stands upright. Returns
/// the object.
inline std::uint32_t addQuad(Building& building, const std::array<glm::vec3, 4>& corners,
                             const Material& material,
                             const glm::mat4& world_from_object = glm::mat4(1)) {
  VertexArrays vertices;
  vertices.positions.assign(corners.begin(), corners.end());
  const glm::vec3 normal =
      glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  vertices.normals.assign(4, normal);
  vertices.texcoords = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
  Mesh mesh;
  mesh.vertices = static_cast<std::uint32_t>(building.vertex_arrays.size());
  mesh.material = static_cast<std::uint32_t>(building.materials.size());
  mesh.indices = {0, 1, 2, 0, 2, 3};
  for (const glm::vec3& corner : corners) mesh.bounds.extend(corner);
  Node node;
  node.world_from_node = world_from_object;
  const Object object{static_cast<std::uint32_t>(building.nodes.size()),
                      static_cast<std::uint32_t>(building.meshes.size())};
  building.vertex_arrays.push_back(std::move(vertices));
  building.materials.push_back(material);
  building.meshes.push_back(std::move(mesh));
  building.nodes.push_back(std::move(node));
  building.objects.push_back(object);
  return static_cast<std::uint32_t>(building.objects.size() - 1);
}

/// An upright rectangle that faces +Z, at depth `z`.
inline std::array<glm::vec3, 4> rectangle(const glm::vec2& low, const glm::vec2& high, float z) {
  return {glm::vec3(low.x, low.y, z), glm::vec3(high.x, low.y, z), glm::vec3(high.x, high.y, z),
          glm::vec3(low.x, high.y, z)};
}

/// A square picture of `size` texels, checkered in squares of `square`.
inline Image checkers(int size, int square, const glm::ivec4& a, const glm::ivec4& b) {
  Image image;
  image.width = image.height = size;
  for (int y = 0; y < size; ++y) {
    for (int x = 0; x < size; ++x) {
      const glm::ivec4& color = (x / square + y / square) % 2 == 0 ? a : b;
      for (int c = 0; c < 4; ++c) image.rgba.push_back(static_cast<std::uint8_t>(color[c]));
    }
  }
  return image;
}

/// 400 squares one behind another, turned, of every kind of material.
inline Building tunnel() {
  Building building;
  building.images.push_back({"", checkers(64, 4, {220, 200, 180, 255}, {60, 80, 90, 0}), {}, ""});
  for (int i = 0; i < 400; ++i) {
    Material material;
    material.base_color = {0.2f + 0.001f * static_cast<float>(i), 0.5f, 0.6f, 0.6f};
    material.image = i % 3 == 0 ? 0 : kNone;
    material.double_sided = i % 2 == 0;
    material.alpha_mode = static_cast<AlphaMode>(i % 7 == 0 ? 2 : i % 3 == 0 ? 1 : 0);
    const auto angle = static_cast<float>(i) * 0.7f;
    addQuad(building, rectangle({-1, -1}, {1, 1}, -1.5f), material,
            glm::rotate(glm::translate(glm::mat4(1), {0, 0, -0.1f * static_cast<float>(i)}), angle,
                        glm::vec3(0.6f, 0.64f, 0.48f)));
  }
  return building;
}

inline std::vector<std::uint32_t> allObjects(const Building& building) {
  std::vector<std::uint32_t> objects(building.objects.size());
  std::iota(objects.begin(), objects.end(), 0u);
  return objects;
}

/// Looks down −Z from the origin so that at z = −1 a world unit is half the picture's height.
inline Camera frontCamera(int width, int height) {
  Camera camera;
  camera.vertical_fov = 1.5707963267948966f;
  camera.aspect = static_cast<float>(width) / static_cast<float>(height);
  camera.near_plane = 0.1f;
  camera.far_plane = 100.0f;
  return camera;
}

inline glm::ivec4 pixelAt(const Image& image, int x, int y) {
  const std::size_t i = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(x));
  return {image.rgba[i], image.rgba[i + 1], image.rgba[i + 2], image.rgba[i + 3]};
}

inline Image draw(const Building& building, const Camera& camera, int width, int height) {
  Renderer renderer(sharedContext(), building);
  renderer.begin(width, height);
  renderer.draw(allObjects(building), camera.view());
  Image image;
  renderer.readColor(image);
  return image;
}

inline const glm::ivec4 kSky(kSkyColor[0], kSkyColor[1], kSkyColor[2], kSkyColor[3]);
inline const glm::ivec4 kRed(255, 0, 0, 255);
inline const glm::ivec4 kGreen(0, 255, 0, 255);
inline const glm::ivec4 kBlue(0, 0, 255, 255);

}  // namespace enfilade::test
