#include "models/mesh_builder.h"

#include <algorithm>
#include <cmath>

namespace enfilade {
namespace {

std::uint16_t toUnorm16(double value) {
  return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0, 1.0) * 65535.0));
}

}  // namespace

std::uint32_t MeshBuilder::vertex(const Corner& corner, const glm::dvec3& normal) {
  vertices_.positions.emplace_back(glm::dvec3(transform_ * glm::dvec4(corner.position, 1)));
  vertices_.normals.emplace_back(glm::normalize(glm::dmat3(transform_) * normal));
  vertices_.texcoords.emplace_back(corner.texcoord);
  const glm::dvec3 color = tint_ * corner.shade;
  vertices_.colors.emplace_back(toUnorm16(color.r), toUnorm16(color.g), toUnorm16(color.b),
                                std::uint16_t{65535});
  unshaded_.emplace_back(toUnorm16(tint_.r), toUnorm16(tint_.g), toUnorm16(tint_.b),
                         std::uint16_t{65535});
  return static_cast<std::uint32_t>(vertices_.positions.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  indices_.insert(indices_.end(), {a, b, c});
}

void MeshBuilder::flatTriangle(const Corner& a, const Corner& b, const Corner& c) {
  const glm::dvec3 normal =
      glm::normalize(glm::cross(b.position - a.position, c.position - a.position));
  triangle(vertex(a, normal), vertex(b, normal), vertex(c, normal));
}

void MeshBuilder::flatQuad(const Corner& a, const Corner& b, const Corner& c, const Corner& d) {
  const glm::dvec3 normal =
      glm::normalize(glm::cross(c.position - a.position, d.position - b.position));
  const std::uint32_t i = vertex(a, normal), j = vertex(b, normal), k = vertex(c, normal),
                      l = vertex(d, normal);
  triangle(i, j, k);
  triangle(i, k, l);
}

void MeshBuilder::box(const glm::dvec3& low, const glm::dvec3& high, const std::string& faces,
                      double texture_size) {
  for (const char face : faces) {
    const bool upper = face < 'a';
    const int axis = (upper ? face - 'X' : face - 'x');
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const auto corner = [&](bool far_u, bool far_v) {
      Corner c;
      c.position[axis] = upper ? high[axis] : low[axis];
      c.position[u] = far_u ? high[u] : low[u];
      c.position[v] = far_v ? high[v] : low[v];
      // Pictures stand upright on the sides: v grows downward.
      const bool v_up = v == 1;
      const glm::dvec2 uv = v_up ? glm::dvec2(c.position[u], -c.position[v])
                                 : glm::dvec2(c.position[v], -c.position[u]);
      c.texcoord = uv / texture_size;
      return c;
    };
    if (upper)
      flatQuad(corner(false, false), corner(true, false), corner(true, true), corner(false, true));
    else
      flatQuad(corner(false, false), corner(false, true), corner(true, true), corner(true, false));
  }
}

std::uint32_t MeshBuilder::addTo(Building& building, const std::string& name,
                                 std::uint32_t material, bool shaded) {
  if (!shaded) vertices_.colors = std::move(unshaded_);
  Mesh mesh;
  mesh.name = name;
  mesh.vertices = static_cast<std::uint32_t>(building.vertex_arrays.size());
  mesh.material = material;
  mesh.indices = std::move(indices_);
  for (const std::uint32_t i : mesh.indices) mesh.bounds.extend(vertices_.positions[i]);
  building.vertex_arrays.push_back(std::move(vertices_));
  building.meshes.push_back(std::move(mesh));
  *this = MeshBuilder();
  return static_cast<std::uint32_t>(building.meshes.size() - 1);
}

}  // namespace enfilade
