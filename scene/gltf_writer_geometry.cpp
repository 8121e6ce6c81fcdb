#include <algorithm>
#include <cassert>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scene/gltf_writer_parts.h"

namespace enfilade {
namespace {

using nlohmann::ordered_json;
using Vertices = GeometryAccessors::Vertices;

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

/// The accessors of one kind that are written, by their bytes: what many arrays share (the
/// positions of furniture that stands in many places, each with its own colours) is written once.
using Written = std::map<std::string_view, int>;

std::string_view textOf(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Used {
  std::vector<bool> meshes;
  std::vector<bool> vertices;
};

Used findUsed(const Building& building) {
  Used used{std::vector<bool>(building.meshes.size(), false),
            std::vector<bool>(building.vertex_arrays.size(), false)};
  for (const Object& object : building.objects) {
    used.meshes[object.mesh] = true;
    used.vertices[building.meshes[object.mesh].vertices] = true;
  }
  return used;
}

int addAccessor(ordered_json& root, ordered_json accessor) {
  root["accessors"].push_back(std::move(accessor));
  return static_cast<int>(root["accessors"].size()) - 1;
}

void addBounds(const std::vector<glm::vec3>& positions, ordered_json& accessor) {
  Box box;
  for (const glm::vec3& p : positions) box.extend(p);
  accessor["min"] = {box.min.x, box.min.y, box.min.z};
  accessor["max"] = {box.max.x, box.max.y, box.max.z};
}

/// One attribute of all vertex arrays, in a buffer view of its own.
class AttributeWriter {
 public:
  AttributeWriter(const Building& building, const Used& used, ordered_json& root, GlbBuffer& buffer,
                  GeometryAccessors& accessors)
      : building_(building), used_(used), root_(root), buffer_(buffer), accessors_(accessors) {}

  template <typename T>
  void write(std::vector<T> VertexArrays::*array, int Vertices::*accessor, const char* type,
             int component_type) {
    const std::size_t start = buffer_.size();
    const std::size_t view = root_["bufferViews"].size();
    Written written;
    for (std::size_t v = 0; v < building_.vertex_arrays.size(); ++v) {
      const VertexArrays& vertices = building_.vertex_arrays[v];
      const std::vector<T>& values = vertices.*array;
      if (!used_.vertices[v] || values.empty()) continue;
      assert(values.size() == vertices.positions.size());
      const auto [known, is_new] = written.try_emplace(textOf(bytesOf(values)), -1);
      accessors_.vertices[v].*accessor = known->second;
      if (!is_new) continue;
      ordered_json json{{"bufferView", view},
                        {"byteOffset", buffer_.add(bytesOf(values)) - start},
                        {"componentType", component_type}};
      if (component_type == kUnsignedShort) json["normalized"] = true;
      json["count"] = values.size();
      json["type"] = type;
      if (accessor == &Vertices::position) addBounds(vertices.positions, json);
      known->second = addAccessor(root_, std::move(json));
      accessors_.vertices[v].*accessor = known->second;
    }
    if (buffer_.size() == start) return;
    addBufferView(root_, start, buffer_.size() - start, kArrayBuffer, sizeof(T));
  }

 private:
  const Building& building_;
  const Used& used_;
  ordered_json& root_;
  GlbBuffer& buffer_;
  GeometryAccessors& accessors_;
};

void writeIndices(const Building& building, const Used& used, ordered_json& root, GlbBuffer& buffer,
                  GeometryAccessors& accessors) {
  const std::size_t start = buffer.size();
  const std::size_t view = root["bufferViews"].size();
  Written written;
  for (std::size_t m = 0; m < building.meshes.size(); ++m) {
    const std::vector<std::uint32_t>& indices = building.meshes[m].indices;
    if (!used.meshes[m]) continue;
    assert(!indices.empty() && "a mesh that is placed must have triangles");
    const auto [known, is_new] = written.try_emplace(textOf(bytesOf(indices)), -1);
    accessors.indices[m] = known->second;
    if (!is_new) continue;
    // 65535 is reserved for the restart of a strip.
    const bool small = *std::max_element(indices.begin(), indices.end()) < 65535;
    const std::size_t offset = small ? buffer.addAs16Bit(indices) : buffer.add(bytesOf(indices));
    known->second = addAccessor(root, {{"bufferView", view},
                                       {"byteOffset", offset - start},
                                       {"componentType", small ? kUnsignedShort : kUnsignedInt},
                                       {"count", indices.size()},
                                       {"type", "SCALAR"}});
    accessors.indices[m] = known->second;
  }
  if (buffer.size() == start) return;
  addBufferView(root, start, buffer.size() - start, kElementArrayBuffer, 0);
}

}  // namespace

int addBufferView(ordered_json& root, std::size_t offset, std::size_t length, int target,
                  std::size_t stride) {
  ordered_json view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", length}};
  if (stride != 0) view["byteStride"] = stride;
  if (target != 0) view["target"] = target;
  root["bufferViews"].push_back(std::move(view));
  return static_cast<int>(root["bufferViews"].size()) - 1;
}

GeometryAccessors writeGeometry(const Building& building, ordered_json& root, GlbBuffer& buffer) {
  GeometryAccessors accessors;
  accessors.vertices.resize(building.vertex_arrays.size());
  accessors.indices.resize(building.meshes.size(), -1);
  const Used used = findUsed(building);
  AttributeWriter attributes(building, used, root, buffer, accessors);
  attributes.write(&VertexArrays::positions, &Vertices::position, "VEC3", kFloat);
  attributes.write(&VertexArrays::normals, &Vertices::normal, "VEC3", kFloat);
  attributes.write(&VertexArrays::texcoords, &Vertices::texcoord, "VEC2", kFloat);
  attributes.write(&VertexArrays::colors, &Vertices::color, "VEC4", kUnsignedShort);
  writeIndices(building, used, root, buffer, accessors);
  return accessors;
}

}  // namespace enfilade
