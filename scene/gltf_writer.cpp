#include "scene/gltf_writer.h"

#include <algorithm>
#include <cassert>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <nlohmann/json.hpp>

#include "scene/file_io.h"
#include "scene/gltf_nodes.h"
#include "scene/gltf_writer_parts.h"

namespace enfilade {
namespace {

using nlohmann::ordered_json;

/// Our meshes at each node, in the order of the objects.
using MeshesByNode = std::vector<std::vector<std::uint32_t>>;

MeshesByNode meshesByNode(const Building& building) {
  MeshesByNode meshes(building.nodes.size());
  for (const Object& object : building.objects) meshes[object.node].push_back(object.mesh);
  return meshes;
}

/// glTF meshes, one for each list of our meshes that stands at a node.
class MeshTable {
 public:
  MeshTable(const Building& building, const GeometryAccessors& accessors, ordered_json& root)
      : building_(building), accessors_(accessors), root_(root) {}

  int gltfMeshOf(const std::vector<std::uint32_t>& meshes) {
    const auto [entry, is_new] =
        by_meshes_.try_emplace(meshes, static_cast<int>(by_meshes_.size()));
    if (!is_new) return entry->second;
    const std::string& name = building_.meshes[meshes.front()].name;
    ordered_json json;
    if (!name.empty()) json["name"] = name;
    for (const std::uint32_t m : meshes) json["primitives"].push_back(primitiveOf(m, name));
    root_["meshes"].push_back(std::move(json));
    return entry->second;
  }

 private:
  ordered_json primitiveOf(std::uint32_t m, const std::string& gltf_mesh_name) const {
    const Mesh& mesh = building_.meshes[m];
    const GeometryAccessors::Vertices& vertices = accessors_.vertices[mesh.vertices];
    ordered_json attributes{{"POSITION", vertices.position}};
    if (vertices.normal >= 0) attributes["NORMAL"] = vertices.normal;
    if (vertices.texcoord >= 0) attributes["TEXCOORD_0"] = vertices.texcoord;
    if (vertices.color >= 0) attributes["COLOR_0"] = vertices.color;
    ordered_json primitive{{"attributes", std::move(attributes)},
                           {"indices", accessors_.indices[m]},
                           {"material", mesh.material}};
    if (mesh.name != gltf_mesh_name) primitive["extras"]["enfilade"]["name"] = mesh.name;
    return primitive;
  }

  const Building& building_;
  const GeometryAccessors& accessors_;
  ordered_json& root_;
  std::map<std::vector<std::uint32_t>, int> by_meshes_;
};

/// parent_from_node such that multiplyThrough gives `world` again; false if there is none.
bool findLocal(const glm::dmat4& world_from_parent, const glm::mat4& world, glm::dmat4& local) {
  const glm::dmat3 linear = glm::inverse(glm::dmat3(world_from_parent));
  glm::dmat4 parent_from_world(linear);
  parent_from_world[3] = glm::dvec4(-(linear * glm::dvec3(world_from_parent[3])), 1.0);
  local = multiplyThrough(parent_from_world, glm::dmat4(world));
  const glm::mat4 back(multiplyThrough(world_from_parent, local));
  for (int c = 0; c < 4; ++c) {
    const float tolerance = 1e-6f * (glm::length(world[c]) + 1.0f);
    // Not a number fails the comparison.
    if (!(glm::length(back[c] - world[c]) <= tolerance)) return false;
  }
  return true;
}

void writeTransform(const glm::dmat4& local, ordered_json& json) {
  glm::dmat4 linear = local;
  linear[3] = glm::dvec4(0, 0, 0, 1);
  if (linear != glm::dmat4(1)) {
    json["matrix"] = std::vector<double>(glm::value_ptr(local), glm::value_ptr(local) + 16);
  } else if (local != glm::dmat4(1)) {
    json["translation"] = {local[3].x, local[3].y, local[3].z};
  }
}

/// All nodes in their order, and the scene.  A child whose parent's transform cannot be undone
/// (a scale of zero) becomes a root, so that it stays where it is.
void writeNodes(const Building& building, const MeshesByNode& meshes_by_node, MeshTable& meshes,
                ordered_json& root) {
  ordered_json nodes = ordered_json::array();
  ordered_json roots = ordered_json::array();
  std::vector<glm::dmat4> world_from_node;
  for (std::size_t n = 0; n < building.nodes.size(); ++n) {
    const Node& node = building.nodes[n];
    assert(node.parent == kNone || node.parent < n);
    glm::dmat4 local(1);
    const bool is_child = node.parent != kNone &&
                          findLocal(world_from_node[node.parent], node.world_from_node, local);
    if (!is_child) local = glm::dmat4(node.world_from_node);
    world_from_node.push_back(is_child ? multiplyThrough(world_from_node[node.parent], local)
                                       : local);
    (is_child ? nodes[node.parent]["children"] : roots).push_back(n);

    ordered_json json = ordered_json::object();
    if (!node.name.empty()) json["name"] = node.name;
    writeTransform(local, json);
    if (!meshes_by_node[n].empty()) json["mesh"] = meshes.gltfMeshOf(meshes_by_node[n]);
    if (!node.extras.empty()) json["extras"]["enfilade"] = ordered_json::parse(node.extras);
    nodes.push_back(std::move(json));
  }
  root["scene"] = 0;
  root["scenes"].push_back(roots.empty() ? ordered_json::object()
                                         : ordered_json{{"nodes", std::move(roots)}});
  if (!nodes.empty()) root["nodes"] = std::move(nodes);
}

/// What glTF has no place for: the building's name, and the order of the objects where it is not
/// that of the nodes.
ordered_json ownExtras(const Building& building, const MeshesByNode& meshes_by_node) {
  ordered_json extras{{"name", building.name}};
  std::vector<std::size_t> next(building.nodes.size(), 0);  // a node's next object, by node order
  for (std::size_t n = 1; n < next.size(); ++n)
    next[n] = next[n - 1] + meshes_by_node[n - 1].size();
  std::vector<std::size_t> order;
  for (const Object& object : building.objects) order.push_back(next[object.node]++);
  if (!std::is_sorted(order.begin(), order.end())) extras["object_order"] = order;
  return extras;
}

}  // namespace

std::vector<std::uint8_t> encodeGlb(const Building& building) {
  ordered_json root;
  root["asset"] = {{"version", "2.0"}, {"generator", "Enfilade"}};
  if (!building.copyright.empty()) root["asset"]["copyright"] = building.copyright;
  root["bufferViews"] = ordered_json::array();
  GlbBuffer buffer;
  const GeometryAccessors accessors = writeGeometry(building, root, buffer);
  writeMaterials(building, root, buffer);
  const MeshesByNode meshes_by_node = meshesByNode(building);
  MeshTable meshes(building, accessors, root);
  writeNodes(building, meshes_by_node, meshes, root);
  writeLights(building, root);
  root["extras"]["enfilade"] = ownExtras(building, meshes_by_node);
  if (root["bufferViews"].empty()) root.erase("bufferViews");
  if (buffer.size() > 0) root["buffers"].push_back({{"byteLength", buffer.size()}});
  const std::string json = root.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  root = nullptr;
  return buffer.encode(json, building.name);
}

void writeGlb(const std::string& file, const Building& building) {
  writeFileAtomically(file, encodeGlb(building));
}

}  // namespace enfilade
