#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace enfilade {

/// Numbers of the glTF specification, for tests that write it by hand.
enum GltfType { kI8 = 5120, kU8 = 5121, kI16 = 5122, kU16 = 5123, kU32 = 5125, kF32 = 5126 };

/// A glTF file made by hand: fill `root`, add accessors, take the bytes.  Knows nothing of our
/// reader or writer.
class GltfBuilder {
 public:
  using Json = nlohmann::json;

  GltfBuilder() { root["asset"] = {{"version", "2.0"}}; }

  template <typename T>
  int view(const std::vector<T>& values, std::size_t stride = 0) {
    while (bin.size() % 4 != 0) bin.push_back(0);
    Json json{{"buffer", 0}, {"byteOffset", bin.size()}, {"byteLength", values.size() * sizeof(T)}};
    if (stride != 0) json["byteStride"] = stride;
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(values.data());
    bin.insert(bin.end(), bytes, bytes + values.size() * sizeof(T));
    return add("bufferViews", json);
  }

  /// Tightly packed.  `more` is merged in: {"normalized": true}.
  template <typename T>
  int accessor(const std::vector<T>& values, const std::string& type, GltfType component_type,
               const Json& more = Json::object()) {
    const std::size_t components = type == "SCALAR" ? 1 : static_cast<std::size_t>(type[3] - '0');
    Json json{{"bufferView", view(values)},
              {"componentType", static_cast<int>(component_type)},
              {"count", values.size() / components},
              {"type", type}};
    json.update(more);
    return add("accessors", json);
  }

  int add(const std::string& array, const Json& json) {
    root[array].push_back(json);
    return static_cast<int>(root[array].size()) - 1;
  }

  /// A mesh of one primitive.
  int mesh(const Json& primitive, const std::string& name = "mesh") {
    return add("meshes", {{"name", name}, {"primitives", Json::array({primitive})}});
  }

  /// One triangle (0,0,0), (1,0,0), (0,1,0) with normals, as a mesh.
  int triangle(const std::string& name = "triangle") {
    const int positions = accessor<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", kF32);
    const int normals = accessor<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, "VEC3", kF32);
    return mesh({{"attributes", {{"POSITION", positions}, {"NORMAL", normals}}}}, name);
  }

  std::vector<std::uint8_t> glb() const {
    Json json = root;
    std::vector<std::uint8_t> body = bin;
    while (body.size() % 4 != 0) body.push_back(0);
    if (!body.empty() && !json.contains("buffers")) {
      json["buffers"] = Json::array({Json{{"byteLength", bin.size()}}});
    }
    return container(json.dump(), body);
  }

  /// JSON with its buffer as a data URI.
  std::string gltf() const {
    Json json = root;
    if (!bin.empty() && !json.contains("buffers")) {
      json["buffers"] =
          Json::array({Json{{"byteLength", bin.size()},
                            {"uri", "data:application/octet-stream;base64," + base64(bin)}}});
    }
    return json.dump();
  }

  static std::string base64(const std::vector<std::uint8_t>& bytes) {
    const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
      std::uint32_t group = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
      }
      for (std::size_t k = 0; k < 4; ++k) {
        text += i + k > bytes.size() ? '=' : digits[group >> (18 - 6 * k) & 63];
      }
    }
    return text;
  }

  static std::vector<std::uint8_t> container(std::string json,
                                             const std::vector<std::uint8_t>& body) {
    while (json.size() % 4 != 0) json += ' ';
    std::vector<std::uint8_t> glb;
    const auto put = [&](std::size_t value) {
      for (int i = 0; i < 4; ++i) glb.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    };
    put(0x46546c67);
    put(2);
    put(20 + json.size() + (body.empty() ? 0 : 8 + body.size()));
    put(json.size());
    put(0x4e4f534a);
    glb.insert(glb.end(), json.begin(), json.end());
    if (body.empty()) return glb;
    put(body.size());
    put(0x004e4942);
    glb.insert(glb.end(), body.begin(), body.end());
    return glb;
  }

  Json root;
  std::vector<std::uint8_t> bin;
};

}  // namespace enfilade
