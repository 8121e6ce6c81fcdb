#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <glm/gtc/constants.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "scene/building.h"

namespace enfilade::bench {

/// Threads to draw with: ENFILADE_BENCH_THREADS, or 2.
inline int threads() {
  const char* text = std::getenv("ENFILADE_BENCH_THREADS");
  return text != nullptr ? std::atoi(text) : 2;
}

/// Bumpy spheres of `per_object` triangles or so each, in a box 8 m wide, 6 m high and 8 m deep
/// around the origin; no two materials of neighbouring spheres are the same when `materials` > 1.
inline Building spheres(int objects, int per_object, int materials, bool textured,
                        bool double_sided) {
  Building building;
  building.name = "spheres";
  if (textured) {
    for (int m = 0; m < materials; ++m) {
      Image image;
      image.width = image.height = 256;
      for (std::uint32_t i = 0; i < 256 * 256; ++i) {
        const bool dark = ((i / 16) ^ (i / 4096)) & 1;
        for (std::uint32_t c = 0; c < 3; ++c) {
          image.rgba.push_back(static_cast<std::uint8_t>(dark ? 90 + 20 * (m % 5) : 200));
        }
        image.rgba.push_back(255);
      }
      building.images.push_back({"", image, {}, ""});
    }
  }
  for (int m = 0; m < materials; ++m) {
    Material material;
    material.base_color = {0.3f + 0.6f * static_cast<float>(m) / static_cast<float>(materials),
                           0.6f, 0.4f, 1};
    material.double_sided = double_sided;
    if (textured) material.image = static_cast<std::uint32_t>(m);
    building.materials.push_back(material);
  }
  const int rows = std::max(2, static_cast<int>(std::sqrt(per_object / 4.0)));
  const int columns = 2 * rows;
  VertexArrays vertices;
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      const float v = static_cast<float>(r) / static_cast<float>(rows);
      const float u = static_cast<float>(c) / static_cast<float>(columns);
      const float theta = v * glm::pi<float>();
      const float phi = u * glm::two_pi<float>();
      const glm::vec3 n(std::sin(theta) * std::cos(phi), std::cos(theta),
                        -std::sin(theta) * std::sin(phi));
      vertices.positions.push_back(n * (1.0f + 0.05f * std::sin(9 * phi) * std::sin(7 * theta)));
      vertices.normals.push_back(n);
      vertices.texcoords.push_back({u, v});
    }
  }
  std::vector<std::uint32_t> indices;
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const auto a = static_cast<std::uint32_t>(r * (columns + 1) + c);
      const auto b = a + static_cast<std::uint32_t>(columns) + 1;
      indices.insert(indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  building.vertex_arrays.push_back(std::move(vertices));
  const int side = static_cast<int>(std::ceil(std::cbrt(objects)));
  for (int o = 0; o < objects; ++o) {
    Mesh mesh;
    mesh.vertices = 0;
    mesh.material = static_cast<std::uint32_t>(o % materials);
    mesh.indices = indices;
    mesh.bounds = {glm::vec3(-1.1f), glm::vec3(1.1f)};
    const glm::vec3 cell(o % side, o / side % side, o / side / side);
    const glm::vec3 place = (cell + 0.5f) / static_cast<float>(side) - 0.5f;
    Node node;
    const float scale = 3.0f / static_cast<float>(side);
    for (int k = 0; k < 3; ++k) node.world_from_node[k][k] = scale;
    node.world_from_node[3] = glm::vec4(place * glm::vec3(8, 6, 8), 1);
    building.nodes.push_back(node);
    building.objects.push_back({static_cast<std::uint32_t>(o), static_cast<std::uint32_t>(o)});
    building.meshes.push_back(std::move(mesh));
  }
  return building;
}

/// A real building's file; empty where it is not there.
inline std::string modelFile(const char* name) {
  const std::string file = std::string(ENFILADE_SOURCE_DIR "/../shared/models/") + name;
  return std::filesystem::exists(file) ? file : std::string();
}

inline std::vector<std::uint32_t> allObjects(const Building& building) {
  std::vector<std::uint32_t> objects(building.objects.size());
  std::iota(objects.begin(), objects.end(), 0u);
  return objects;
}

}  // namespace enfilade::bench
