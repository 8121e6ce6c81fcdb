#include "preprocess/light_colors.h"

#include <algorithm>
#include <cmath>

#include "preprocess/point_grid.h"
#include "preprocess/work_crew.h"

namespace enfilade {
namespace {

std::uint16_t toUnorm16(float value) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0f, 1.0f) * 65535.0f));
}

/// One object with colours of its own.
struct Colored {
  Mesh mesh;
  VertexArrays vertices;
};

Colored colored(const Building& building, const WorldGeometry& world, const LightPoints& points,
                const std::vector<glm::vec3>& light, const LightTone& tone, std::uint32_t object) {
  const Mesh& mesh = building.meshOf(building.objects[object]);
  const VertexArrays& from = building.vertex_arrays[mesh.vertices];
  const VertexRange range = verticesOf(world, object);
  const std::vector<std::uint32_t> source = sourceVertices(building, world, object);
  const PointGrid grid(world, points, object);
  Colored result{mesh, {}};
  VertexArrays& to = result.vertices;
  std::vector<std::uint32_t> moved(from.positions.size(), kNone);
  for (std::uint32_t i = 0; i < range.count; ++i) {
    const std::uint32_t v = source[i];
    moved[v] = i;
    to.positions.push_back(from.positions[v]);
    if (!from.normals.empty()) to.normals.push_back(from.normals[v]);
    if (!from.texcoords.empty()) to.texcoords.push_back(from.texcoords[v]);
    glm::vec4 color(tone.shade(grid.lightAt(range.first + i, light)), 1);
    if (!from.colors.empty()) color *= glm::vec4(from.colors[v]) / 65535.0f;
    to.colors.emplace_back(toUnorm16(color.r), toUnorm16(color.g), toUnorm16(color.b),
                           toUnorm16(color.a));
  }
  for (std::uint32_t& i : result.mesh.indices) i = moved[i];
  return result;
}

}  // namespace

Building colorByLight(const Building& building, const WorldGeometry& world,
                      const LightPoints& points, const std::vector<glm::vec3>& light,
                      const LightTone& tone, int threads) {
  std::vector<Colored> of_object(building.objects.size());
  shareOutJobs(building.objects.size(), threads, [&]() -> Worker {
    return [&](std::size_t o) {
      const auto object = static_cast<std::uint32_t>(o);
      if (building.materialOf(building.objects[o]).unlit || world.objects[o].count == 0) return;
      of_object[o] = colored(building, world, points, light, tone, object);
    };
  });
  Building result = building;
  for (std::size_t o = 0; o < of_object.size(); ++o) {
    if (of_object[o].mesh.indices.empty()) continue;
    of_object[o].mesh.vertices = static_cast<std::uint32_t>(result.vertex_arrays.size());
    result.vertex_arrays.push_back(std::move(of_object[o].vertices));
    result.objects[o].mesh = static_cast<std::uint32_t>(result.meshes.size());
    result.meshes.push_back(std::move(of_object[o].mesh));
  }
  for (Material& material : result.materials) material.unlit = true;
  return result;
}

}  // namespace enfilade
