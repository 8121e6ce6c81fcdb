#include "scene/gltf_reader.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scene/building_repair.h"
#include "scene/file_io.h"
#include "scene/gltf_lights.h"
#include "scene/gltf_materials.h"
#include "scene/gltf_meshes.h"
#include "scene/gltf_model.h"
#include "scene/gltf_nodes.h"

namespace enfilade {
namespace {

using nlohmann::json;

/// Nodes times primitives: nothing else in the file bounds their number.
constexpr std::size_t kMostObjects = std::size_t{1} << 22;

/// All nodes, and an object for every primitive of each.
void readNodes(const GltfModel& gltf, MeshReader& meshes, Building& building,
               WarningLog& warnings) {
  const GltfNodeTree tree = readNodeTree(gltf);
  std::vector<glm::dmat4> world_from_node;
  std::vector<int> gltf_nodes;
  for (const auto& [gltf_node, parent] : tree.entries) {
    const tinygltf::Node& source = gltf->nodes[static_cast<std::size_t>(gltf_node)];
    const glm::dmat4 own = parentFromNode(gltf, gltf_node);
    world_from_node.push_back(parent == kNone ? own
                                              : multiplyThrough(world_from_node[parent], own));
    Node node;
    node.name = source.name;
    node.parent = parent;
    node.world_from_node = glm::mat4(world_from_node.back());
    node.extras = gltf.node_extras[static_cast<std::size_t>(gltf_node)];
    building.nodes.push_back(std::move(node));
    gltf_nodes.push_back(gltf_node);

    if (source.mesh < 0) continue;
    if (source.skin >= 0) warnings.add("skin ignored", "node '" + oneLine(source.name) + "'");
    const auto index = static_cast<std::uint32_t>(building.nodes.size() - 1);
    const std::vector<std::uint32_t>& own_meshes = meshes.meshesOf(source.mesh);
    if (own_meshes.size() > kMostObjects - building.objects.size()) {
      gltf.fail(fmt::format("holds over {} objects", kMostObjects));
    }
    for (const std::uint32_t mesh : own_meshes) building.objects.push_back({index, mesh});
  }
  readLights(gltf, gltf_nodes, building, warnings);
}

/// The writer's own order of the objects, where it differs from the order of the nodes.
void restoreObjectOrder(const json& order, Building& building, WarningLog& warnings) {
  std::vector<Object> objects;
  std::vector<bool> taken(building.objects.size(), false);
  for (const json& index : order) {
    const bool valid = index.is_number_unsigned() && index < building.objects.size();
    if (!valid || taken[index.get<std::size_t>()]) break;
    taken[index.get<std::size_t>()] = true;
    objects.push_back(building.objects[index.get<std::size_t>()]);
  }
  if (objects.size() != building.objects.size() || order.size() != objects.size()) {
    warnings.add("order of objects that does not fit them, ignored",
                 "extras.enfilade.object_order");
    return;
  }
  building.objects = std::move(objects);
}

void readOwnExtras(const GltfModel& gltf, Building& building, WarningLog& warnings) {
  building.name = std::filesystem::path(gltf.file).stem().string();
  if (gltf.extras.empty()) return;
  const json extras = json::parse(gltf.extras);
  if (!extras.is_object()) return;
  if (extras.contains("name") && extras["name"].is_string()) building.name = extras["name"];
  if (extras.contains("object_order") && extras["object_order"].is_array()) {
    restoreObjectOrder(extras["object_order"], building, warnings);
  }
}

/// Whoever samples a picture may count on coordinates.
void fillMissingTexcoords(Building& building, WarningLog& warnings) {
  for (const Mesh& mesh : building.meshes) {
    VertexArrays& vertices = building.vertex_arrays[mesh.vertices];
    if (building.materials[mesh.material].image == kNone || !vertices.texcoords.empty()) continue;
    vertices.texcoords.assign(vertices.positions.size(), glm::vec2(0));
    warnings.add("picture without texture coordinates", "mesh '" + oneLine(mesh.name) + "'");
  }
}

}  // namespace

Building decodeGltf(std::span<const std::uint8_t> bytes, const std::string& file,
                    Warnings* warnings) {
  WarningLog log;
  const GltfModel gltf = loadGltfModel(bytes, file, log);
  Building building;
  building.copyright = gltf->asset.copyright;
  const std::vector<TextureMapping> mappings = readMaterials(gltf, building, log);
  MeshReader meshes(gltf, mappings, building, log);
  readNodes(gltf, meshes, building, log);
  if (building.objects.empty()) gltf.fail("holds no triangles" + log.because());
  readOwnExtras(gltf, building, log);
  requireWithinReach(building, file);
  dropUnusedVertexArrays(building);
  mendPositions(building);
  fillMissingTexcoords(building, log);
  mendNormals(building, log);
  if (warnings != nullptr) *warnings = log.lines();
  return building;
}

Building readGltf(const std::string& file, Warnings* warnings) {
  return decodeGltf(readFile(file), file, warnings);
}

}  // namespace enfilade
