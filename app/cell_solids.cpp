#include "app/cell_solids.h"

#include <array>
#include <cmath>
#include <glm/gtc/color_space.hpp>
#include <span>
#include <string>
#include <utility>

#include "app/portal_color.h"

namespace enfilade {
namespace {

using Label = CellGrid::Label;

/// Voxels [begin, end) of a column.
struct Span {
  int begin, end;
};

/// One mesh as it grows.
struct Surface {
  VertexArrays vertices{};
  std::vector<std::uint32_t> indices{};

  void addPolygon(std::span<const glm::vec3> corners, const glm::vec3& normal) {
    const auto first = static_cast<std::uint32_t>(vertices.positions.size());
    vertices.positions.insert(vertices.positions.end(), corners.begin(), corners.end());
    vertices.normals.insert(vertices.normals.end(), corners.size(), normal);
    for (std::uint32_t i = 2; i < corners.size(); ++i) {
      indices.insert(indices.end(), {first, first + i - 1, first + i});
    }
  }
};

/// Calls visit(label, span) for the runs of a column; for none outside the grid.
template <class Visit>
void forEachRun(const CellGrid& grid, int x, int z, Visit&& visit) {
  if (x < 0 || z < 0 || x >= grid.size().x || z >= grid.size().z) return;
  int begin = 0;
  for (const CellGrid::Run& run : grid.column(x, z)) {
    visit(run.label, Span{begin, run.end_y});
    begin = run.end_y;
  }
}

/// What of `span` in column (x, z) is not of `label`.
std::vector<Span> notOfLabel(const CellGrid& grid, int x, int z, Label label, Span span) {
  std::vector<Span> rest;
  forEachRun(grid, x, z, [&](Label other, Span run) {
    if (other != label || run.end <= span.begin || run.begin >= span.end) return;
    if (run.begin > span.begin) rest.push_back({span.begin, run.begin});
    span.begin = run.end;
  });
  if (span.begin < span.end) rest.push_back(span);
  return rest;
}

class CellSurfaces {
 public:
  std::vector<Surface> surfaces;  ///< one a cell

  CellSurfaces(const CellGrid& grid, std::size_t cells) : surfaces(cells), grid_(grid) {
    for (int x = 0; x < grid.size().x; ++x) {
      for (int z = 0; z < grid.size().z; ++z) {
        forEachRun(grid, x, z, [&](Label label, Span run) {
          if (label != kExterior && label < cells) addRun(x, z, label, run);
        });
      }
    }
  }

 private:
  const CellGrid& grid_;

  glm::vec3 at(int x, int y, int z) const {
    return grid_.origin() + grid_.voxel() * glm::vec3(x, y, z);
  }

  /// The rectangle from `corner` along two sides [voxels]; its normal is along × up.
  void addFace(Label label, glm::ivec3 corner, glm::ivec3 along, glm::ivec3 up) {
    const auto point = [&](const glm::ivec3& v) { return at(v.x, v.y, v.z); };
    const std::array<glm::vec3, 4> corners{point(corner), point(corner + along),
                                           point(corner + along + up), point(corner + up)};
    const glm::vec3 normal = glm::normalize(glm::cross(glm::vec3(along), glm::vec3(up)));
    surfaces[label].addPolygon(corners, normal);
  }

  void addRun(int x, int z, Label label, Span run) {
    addFace(label, {x, run.end, z}, {0, 0, 1}, {1, 0, 0});
    addFace(label, {x, run.begin, z}, {1, 0, 0}, {0, 0, 1});
    for (const Span& s : notOfLabel(grid_, x + 1, z, label, run)) {
      addFace(label, {x + 1, s.begin, z + 1}, {0, 0, -1}, {0, s.end - s.begin, 0});
    }
    for (const Span& s : notOfLabel(grid_, x - 1, z, label, run)) {
      addFace(label, {x, s.begin, z}, {0, 0, 1}, {0, s.end - s.begin, 0});
    }
    for (const Span& s : notOfLabel(grid_, x, z + 1, label, run)) {
      addFace(label, {x, s.begin, z + 1}, {1, 0, 0}, {0, s.end - s.begin, 0});
    }
    for (const Span& s : notOfLabel(grid_, x, z - 1, label, run)) {
      addFace(label, {x + 1, s.begin, z}, {-1, 0, 0}, {0, s.end - s.begin, 0});
    }
  }
};

Material seeThrough(const std::string& name, const glm::vec3& srgb, float alpha) {
  Material material;
  material.name = name;
  material.base_color = glm::vec4(glm::convertSRGBToLinear(srgb), alpha);
  material.alpha_mode = AlphaMode::kBlend;
  material.double_sided = true;
  return material;
}

glm::vec3 rgb(unsigned hex) {
  return glm::vec3(hex >> 16 & 255u, hex >> 8 & 255u, hex & 255u) / 255.0f;
}

/// A light colour of some hue [degrees], sRGB.
glm::vec3 hueColor(float degrees) {
  const glm::vec3 third(0.0f, 120.0f, 240.0f);
  return 0.65f + 0.3f * glm::cos(glm::radians(degrees - third));
}

/// Puts the surface at the end of the building, in a node and with a material of its own.
void addObject(Building& building, const std::string& name, Material material, Surface surface) {
  Mesh mesh;
  mesh.name = name;
  mesh.vertices = static_cast<std::uint32_t>(building.vertex_arrays.size());
  mesh.material = static_cast<std::uint32_t>(building.materials.size());
  mesh.indices = std::move(surface.indices);
  for (const glm::vec3& p : surface.vertices.positions) mesh.bounds.extend(p);
  Node node;
  node.name = name;
  building.objects.push_back({static_cast<std::uint32_t>(building.nodes.size()),
                              static_cast<std::uint32_t>(building.meshes.size())});
  building.nodes.push_back(std::move(node));
  building.meshes.push_back(std::move(mesh));
  building.vertex_arrays.push_back(std::move(surface.vertices));
  building.materials.push_back(std::move(material));
}

}  // namespace

Building cellSolids(const House& house) {
  constexpr unsigned kShut = 0x707070;
  Building building;
  building.name = house.info.model_name + ": cells and portals";
  const CellGraph& graph = house.graph;
  CellSurfaces cells(house.grid, graph.cells.size());
  for (CellId id = 1; id < graph.cells.size(); ++id) {
    if (cells.surfaces[id].indices.empty()) continue;
    addObject(building, graph.cells[id].name,
              seeThrough("cell", hueColor(137.508f * static_cast<float>(id)), 0.3f),
              std::move(cells.surfaces[id]));
  }
  for (const Portal& portal : graph.portals) {
    Surface surface;
    surface.addPolygon(portal.polygon, portal.plane.normal);
    const unsigned color = portal.active ? portalColor(portal.kind) : kShut;
    addObject(building, portal.name, seeThrough("portal", rgb(color), 0.7f), std::move(surface));
  }
  return building;
}

}  // namespace enfilade
