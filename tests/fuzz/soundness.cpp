#include "tests/fuzz/soundness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace enfilade::fuzz {
namespace {

bool isFinite(const glm::vec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

bool isFinite(const Box& box) { return isFinite(box.min) && isFinite(box.max); }

bool isFinite(const glm::mat4& m) {
  for (int c = 0; c < 4; ++c) {
    if (!isFinite(glm::vec3(m[c])) || !std::isfinite(m[c].w)) return false;
  }
  return true;
}

void requireSound(const VertexArrays& vertices) {
  const std::size_t count = vertices.positions.size();
  require(vertices.normals.size() == count, "a normal for each vertex");
  for (const std::size_t size : {vertices.texcoords.size(), vertices.colors.size()}) {
    require(size == 0 || size == count, "an attribute for each vertex or for none");
  }
  for (const glm::vec3& p : vertices.positions) require(isFinite(p), "finite positions");
  for (const glm::vec3& n : vertices.normals) {
    require(std::abs(glm::dot(n, n) - 1.0f) < 1e-3f, "unit normals");
  }
  for (const glm::vec2& t : vertices.texcoords) {
    require(std::isfinite(t.x) && std::isfinite(t.y), "finite texture coordinates");
  }
}

void requireSound(const Mesh& mesh, const Building& building) {
  require(mesh.vertices < building.vertex_arrays.size(), "a mesh's vertices are there");
  require(mesh.material < building.materials.size(), "a mesh's material is there");
  require(!mesh.indices.empty() && mesh.indices.size() % 3 == 0, "whole triangles");
  const VertexArrays& vertices = building.vertex_arrays[mesh.vertices];
  for (const std::uint32_t i : mesh.indices) {
    require(i < vertices.positions.size(), "a triangle's corners are there");
    require(mesh.bounds.contains(vertices.positions[i]), "a mesh's bounds hold it");
  }
  const bool has_picture = building.materials[mesh.material].image != kNone;
  require(!has_picture || !vertices.texcoords.empty(), "coordinates for a picture");
}

void requireSound(const Material& material, const Building& building) {
  require(material.image == kNone || material.image < building.images.size(),
          "a material's picture is there");
  for (int c = 0; c < 4; ++c) {
    require(material.base_color[c] >= 0 && material.base_color[c] <= 1, "a colour from 0 to 1");
  }
  require(std::isfinite(material.alpha_cutoff), "a finite cutoff");
}

void requireSound(const Light& light, const Building& building) {
  require(light.node < building.nodes.size(), "a light's node is there");
  require(isFinite(light.color), "a finite colour");
  require(std::isfinite(light.intensity) && std::isfinite(light.range), "a finite light");
}

}  // namespace

void require(bool holds, const std::string& what) {
  if (!holds) throw std::logic_error("does not hold: " + what);
}

void requireOneLine(const std::string& message) {
  require(!message.empty(), "a message says something");
  require(std::none_of(message.begin(), message.end(),
                       [](unsigned char c) { return c < 0x20 || c == 0x7f; }),
          "a message is one line: " + message);
}

void requireSound(const Building& building) {
  require(!building.objects.empty(), "a building has objects");
  for (const VertexArrays& vertices : building.vertex_arrays) requireSound(vertices);
  for (const Mesh& mesh : building.meshes) requireSound(mesh, building);
  for (const Material& material : building.materials) requireSound(material, building);
  for (const Light& light : building.lights) requireSound(light, building);
  for (const TextureImage& image : building.images) {
    require(image.image.width > 0 && image.image.height > 0, "a picture has pixels");
    require(image.image.rgba.size() == std::size_t{4} *
                                           static_cast<std::size_t>(image.image.width) *
                                           static_cast<std::size_t>(image.image.height),
            "a picture's pixels are there");
  }
  for (std::size_t i = 0; i < building.nodes.size(); ++i) {
    const Node& node = building.nodes[i];
    require(node.parent == kNone || node.parent < i, "parents stand before their children");
    require(isFinite(node.world_from_node), "a finite transform");
  }
  for (const Object& object : building.objects) {
    require(object.node < building.nodes.size(), "an object's node is there");
    require(object.mesh < building.meshes.size(), "an object's mesh is there");
  }
  require(isFinite(worldBounds(building)), "finite bounds in the world");
}

void requireSound(const CellGraph& graph) {
  require(!graph.storeys.empty() && !graph.cells.empty(), "a storey and a cell");
  for (const Cell& cell : graph.cells) {
    require(cell.storey >= 0 && static_cast<std::size_t>(cell.storey) < graph.storeys.size(),
            "a cell's storey is there");
    for (const PortalId id : cell.portals) require(id < graph.portals.size(), "a cell's portals");
  }
  for (const Portal& portal : graph.portals) {
    require(portal.front < graph.cells.size() && portal.back < graph.cells.size() &&
                portal.front != portal.back,
            "a portal's two cells are there");
    require(portal.polygon.size() >= 3, "a portal has three corners");
    for (const glm::vec3& corner : portal.polygon) require(isFinite(corner), "finite corners");
    require(std::abs(glm::length(portal.plane.normal) - 1) < 0.01f && std::isfinite(portal.plane.d),
            "a portal has a plane");
  }
}

void requireSound(const CameraPath& path) {
  require(!path.poses.empty(), "a path has poses");
  require(path.vertical_fov > 0 && path.vertical_fov < 3.1416f, "a field of view");
  double last = path.poses.front().time;
  for (const TimedPose& timed : path.poses) {
    require(std::isfinite(timed.time) && timed.time >= last, "poses in order");
    require(isFinite(timed.pose.position), "finite places");
    require(std::abs(glm::length(timed.pose.world_from_camera_rotation) - 1) < 1e-3f,
            "unit rotations");
    last = timed.time;
  }
  for (std::size_t i = 1; i < path.doors.size(); ++i) {
    require(path.doors[i].time >= path.doors[i - 1].time, "doors in order");
  }
}

}  // namespace enfilade::fuzz
