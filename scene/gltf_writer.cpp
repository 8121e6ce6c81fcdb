#include "scene/gltf_writer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "scene/file_io.h"
#include "scene/glb_buffer.h"
#include "scene/gltf_nodes.h"

namespace enfilade {
namespace {

using nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kFloat = 5126;
constexpr int kArrayBuffer = 34962;
constexpr int kElementArrayBuffer = 34963;

template <typename T>
std::span<const std::uint8_t> bytesOf(const std::vector<T>& values) {
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

/// Accessors of one VertexArrays, -1 for what it has not.
struct VertexAccessors {
  int position = -1;
  int normal = -1;
  int texcoord = -1;
  int color = -1;
};

class GltfEncoder {
 public:
  explicit GltfEncoder(const Building& building) : building_(building) {}

  std::vector<std::uint8_t> encode();

 private:
  void findUsed();
  template <typename T>
  void writeAttribute(std::vector<T> VertexArrays::*array, int VertexAccessors::*accessor,
                      const char* type, int component_type);
  void writeIndices();
  void writeImages();
  void writeMaterials();
  int samplerOf(const Material& material);
  int textureOf(const Material& material);
  void writeNodes();
  int gltfMeshOf(const std::vector<std::uint32_t>& meshes);
  void writeOwnExtras();
  int addBufferView(std::size_t offset, std::size_t length, int target, std::size_t stride);
  int addAccessor(ordered_json accessor);

  const Building& building_;
  GlbBuffer buffer_;
  ordered_json root_;
  std::vector<bool> mesh_used_;
  std::vector<bool> vertices_used_;
  std::vector<VertexAccessors> vertex_accessors_;
  std::vector<int> index_accessors_;                       ///< one a mesh
  std::vector<std::vector<std::uint32_t>> node_meshes_;    ///< one a node
  std::map<std::vector<std::uint32_t>, int> gltf_meshes_;  ///< by the meshes in it
  std::map<std::tuple<Wrap, Wrap, bool>, int> samplers_;
  std::map<std::pair<std::uint32_t, int>, int> textures_;  ///< by image and sampler
};

int lastIndex(const ordered_json& array) { return static_cast<int>(array.size()) - 1; }

int GltfEncoder::addBufferView(std::size_t offset, std::size_t length, int target,
                               std::size_t stride) {
  ordered_json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}};
  if (stride != 0) view["byteStride"] = stride;
  if (target != 0) view["target"] = target;
  root_["bufferViews"].push_back(std::move(view));
  return lastIndex(root_["bufferViews"]);
}

int GltfEncoder::addAccessor(ordered_json accessor) {
  root_["accessors"].push_back(std::move(accessor));
  return lastIndex(root_["accessors"]);
}

void GltfEncoder::findUsed() {
  mesh_used_.assign(building_.meshes.size(), false);
  vertices_used_.assign(building_.vertex_arrays.size(), false);
  node_meshes_.resize(building_.nodes.size());
  for (const Object& object : building_.objects) {
    mesh_used_[object.mesh] = true;
    vertices_used_[building_.meshes[object.mesh].vertices] = true;
    node_meshes_[object.node].push_back(object.mesh);
  }
}

/// One attribute of all vertex arrays, in a buffer view of its own.
template <typename T>
void GltfEncoder::writeAttribute(std::vector<T> VertexArrays::*array,
                                 int VertexAccessors::*accessor, const char* type,
                                 int component_type) {
  const std::size_t start = buffer_.size();
  const auto view = static_cast<int>(root_["bufferViews"].size());
  for (std::size_t v = 0; v < building_.vertex_arrays.size(); ++v) {
    const std::vector<T>& values = building_.vertex_arrays[v].*array;
    if (!vertices_used_[v] || values.empty()) continue;
    assert(values.size() == building_.vertex_arrays[v].positions.size());
    ordered_json json{{"bufferView", view},
                      {"byteOffset", buffer_.add(bytesOf(values)) - start},
                      {"componentType", component_type}};
    if (component_type == kUnsignedShort) json["normalized"] = true;
    json["count"] = values.size();
    json["type"] = type;
    if constexpr (std::is_same_v<T, glm::vec3>) {
      if (accessor == &VertexAccessors::position) {
        Box box;
        for (const glm::vec3& p : values) box.extend(p);
        json["min"] = {box.min.x, box.min.y, box.min.z};
        json["max"] = {box.max.x, box.max.y, box.max.z};
      }
    }
    vertex_accessors_[v].*accessor = addAccessor(std::move(json));
  }
  if (buffer_.size() > start) {
    addBufferView(start, buffer_.size() - start, kArrayBuffer, sizeof(T));
  }
}

void GltfEncoder::writeIndices() {
  index_accessors_.assign(building_.meshes.size(), -1);
  const std::size_t start = buffer_.size();
  const auto view = static_cast<int>(root_["bufferViews"].size());
  for (std::size_t m = 0; m < building_.meshes.size(); ++m) {
    const std::vector<std::uint32_t>& indices = building_.meshes[m].indices;
    if (!mesh_used_[m]) continue;
    assert(!indices.empty() && "a mesh that is placed must have triangles");
    // 65535 is reserved for the restart of a strip.
    const bool small = *std::max_element(indices.begin(), indices.end()) < 65535;
    const std::size_t offset = small ? buffer_.addAs16Bit(indices) : buffer_.add(bytesOf(indices));
    index_accessors_[m] = addAccessor({{"bufferView", view},
                                       {"byteOffset", offset - start},
                                       {"componentType", small ? kUnsignedShort : kUnsignedInt},
                                       {"count", indices.size()},
                                       {"type", "SCALAR"}});
  }
  if (buffer_.size() > start) {
    addBufferView(start, buffer_.size() - start, kElementArrayBuffer, 0);
  }
}

void GltfEncoder::writeImages() {
  for (const TextureImage& image : building_.images) {
    const bool encoded = !image.encoded.empty();
    const std::size_t start = buffer_.size();
    std::size_t size = image.encoded.size();
    if (encoded) {
      buffer_.add(image.encoded);
    } else {
      std::vector<std::uint8_t> png = encodePng(image.image);
      size = png.size();
      buffer_.addOwned(std::move(png));
    }
    root_["images"].push_back({{"name", image.name},
                               {"mimeType", encoded ? image.mime_type : "image/png"},
                               {"bufferView", addBufferView(start, size, 0, 0)}});
  }
}

int GltfEncoder::samplerOf(const Material& material) {
  const auto key = std::tuple(material.wrap_s, material.wrap_t, material.nearest_filter);
  const auto [entry, is_new] = samplers_.try_emplace(key, static_cast<int>(samplers_.size()));
  if (is_new) {
    const auto number = [](Wrap wrap) {
      if (wrap == Wrap::kClampToEdge) return 33071;
      return wrap == Wrap::kMirroredRepeat ? 33648 : 10497;
    };
    root_["samplers"].push_back({{"magFilter", material.nearest_filter ? 9728 : 9729},
                                 {"minFilter", material.nearest_filter ? 9986 : 9987},
                                 {"wrapS", number(material.wrap_s)},
                                 {"wrapT", number(material.wrap_t)}});
  }
  return entry->second;
}

int GltfEncoder::textureOf(const Material& material) {
  const int sampler = samplerOf(material);
  const auto [entry, is_new] =
      textures_.try_emplace(std::pair(material.image, sampler), static_cast<int>(textures_.size()));
  if (is_new) root_["textures"].push_back({{"sampler", sampler}, {"source", material.image}});
  return entry->second;
}

void GltfEncoder::writeMaterials() {
  for (const Material& material : building_.materials) {
    ordered_json json;
    if (!material.name.empty()) json["name"] = material.name;
    const glm::vec4& c = material.base_color;
    ordered_json pbr{{"baseColorFactor", {c.r, c.g, c.b, c.a}}, {"metallicFactor", 0}};
    if (material.image != kNone) pbr["baseColorTexture"] = {{"index", textureOf(material)}};
    json["pbrMetallicRoughness"] = std::move(pbr);
    if (material.alpha_mode == AlphaMode::kMask) {
      json["alphaMode"] = "MASK";
      json["alphaCutoff"] = material.alpha_cutoff;
    } else if (material.alpha_mode == AlphaMode::kBlend) {
      json["alphaMode"] = "BLEND";
    }
    if (material.double_sided) json["doubleSided"] = true;
    if (material.unlit) {
      json["extensions"]["KHR_materials_unlit"] = ordered_json::object();
      root_["extensionsUsed"] = {"KHR_materials_unlit"};
    }
    root_["materials"].push_back(std::move(json));
  }
}

/// The glTF mesh with these of our meshes as its primitives.
int GltfEncoder::gltfMeshOf(const std::vector<std::uint32_t>& meshes) {
  const auto [entry, is_new] =
      gltf_meshes_.try_emplace(meshes, static_cast<int>(gltf_meshes_.size()));
  if (!is_new) return entry->second;
  const std::string& name = building_.meshes[meshes.front()].name;
  ordered_json json;
  if (!name.empty()) json["name"] = name;
  for (const std::uint32_t m : meshes) {
    const Mesh& mesh = building_.meshes[m];
    const VertexAccessors& accessors = vertex_accessors_[mesh.vertices];
    ordered_json attributes{{"POSITION", accessors.position}};
    if (accessors.normal >= 0) attributes["NORMAL"] = accessors.normal;
    if (accessors.texcoord >= 0) attributes["TEXCOORD_0"] = accessors.texcoord;
    if (accessors.color >= 0) attributes["COLOR_0"] = accessors.color;
    ordered_json primitive{{"attributes", std::move(attributes)},
                           {"indices", index_accessors_[m]},
                           {"material", mesh.material}};
    if (mesh.name != name) primitive["extras"]["enfilade"]["name"] = mesh.name;
    json["primitives"].push_back(std::move(primitive));
  }
  root_["meshes"].push_back(std::move(json));
  return entry->second;
}

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
  if (local == glm::dmat4(1)) return;
  glm::dmat4 linear = local;
  linear[3] = glm::dvec4(0, 0, 0, 1);
  if (linear == glm::dmat4(1)) {
    json["translation"] = {local[3].x, local[3].y, local[3].z};
  } else {
    json["matrix"] = std::vector<double>(glm::value_ptr(local), glm::value_ptr(local) + 16);
  }
}

void GltfEncoder::writeNodes() {
  ordered_json nodes = ordered_json::array();
  ordered_json roots = ordered_json::array();
  std::vector<glm::dmat4> world_from_node;
  for (std::size_t n = 0; n < building_.nodes.size(); ++n) {
    const Node& node = building_.nodes[n];
    assert(node.parent == kNone || node.parent < n);
    glm::dmat4 local(node.world_from_node);
    const bool child = node.parent != kNone &&
                       findLocal(world_from_node[node.parent], node.world_from_node, local);
    if (!child) local = glm::dmat4(node.world_from_node);
    world_from_node.push_back(child ? multiplyThrough(world_from_node[node.parent], local) : local);
    if (child) {
      nodes[node.parent]["children"].push_back(n);
    } else {
      roots.push_back(n);
    }
    ordered_json json = ordered_json::object();
    if (!node.name.empty()) json["name"] = node.name;
    writeTransform(local, json);
    if (!node_meshes_[n].empty()) json["mesh"] = gltfMeshOf(node_meshes_[n]);
    if (!node.extras.empty()) {
      json["extras"]["enfilade"] = ordered_json::parse(node.extras, nullptr, false);
    }
    nodes.push_back(std::move(json));
  }
  ordered_json scene = ordered_json::object();
  if (!roots.empty()) scene["nodes"] = std::move(roots);
  root_["scene"] = 0;
  root_["scenes"].push_back(std::move(scene));
  if (!nodes.empty()) root_["nodes"] = std::move(nodes);
}

/// What glTF has no place for: the building's name, and the order of the objects where it is not
/// that of the nodes.
void GltfEncoder::writeOwnExtras() {
  ordered_json extras{{"name", building_.name}};
  std::vector<std::size_t> next(building_.nodes.size(),
                                0);  ///< a node's next object, by node order
  for (std::size_t n = 1; n < next.size(); ++n) next[n] = next[n - 1] + node_meshes_[n - 1].size();
  std::vector<std::size_t> order;
  for (const Object& object : building_.objects) order.push_back(next[object.node]++);
  if (!std::is_sorted(order.begin(), order.end())) extras["object_order"] = order;
  root_["extras"]["enfilade"] = std::move(extras);
}

std::vector<std::uint8_t> GltfEncoder::encode() {
  root_["asset"] = {{"version", "2.0"}, {"generator", "Enfilade"}};
  if (!building_.copyright.empty()) root_["asset"]["copyright"] = building_.copyright;
  root_["bufferViews"] = ordered_json::array();
  findUsed();
  vertex_accessors_.resize(building_.vertex_arrays.size());
  writeAttribute(&VertexArrays::positions, &VertexAccessors::position, "VEC3", kFloat);
  writeAttribute(&VertexArrays::normals, &VertexAccessors::normal, "VEC3", kFloat);
  writeAttribute(&VertexArrays::texcoords, &VertexAccessors::texcoord, "VEC2", kFloat);
  writeAttribute(&VertexArrays::colors, &VertexAccessors::color, "VEC4", kUnsignedShort);
  writeIndices();
  writeImages();
  writeMaterials();
  writeNodes();
  writeOwnExtras();
  if (root_["bufferViews"].empty()) root_.erase("bufferViews");
  if (buffer_.size() > 0) root_["buffers"].push_back({{"byteLength", buffer_.size()}});
  const std::string json = root_.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
  root_ = nullptr;
  return buffer_.encode(json, building_.name);
}

}  // namespace

std::vector<std::uint8_t> encodeGlb(const Building& building) {
  return GltfEncoder(building).encode();
}

void writeGlb(const std::string& file, const Building& building) {
  writeFileAtomically(file, encodeGlb(building));
}

}  // namespace enfilade
