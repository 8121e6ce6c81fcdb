#include <sodium.h>

#include <cassert>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "scene/camera_path.h"
#include "scene/file_io.h"
#include "scene/gltf_writer_parts.h"

namespace enfilade {
namespace {

using nlohmann::ordered_json;

constexpr int kFloat = 5126;    // glTF's number for 32-bit floats
constexpr float kNear = 0.05f;  // [m] glTF cameras must have a near plane
constexpr float kFar = 500.0f;  // [m]

/// Numbers of an animation, as glTF stores them.
struct Keys {
  std::vector<float> times;         // [s] strictly increasing, from 0
  std::vector<float> translations;  // three a key
  std::vector<float> rotations;     // x, y, z, w a key, none turned about from the one before
};

// glTF has times in 32 bits, which increase: of poses at one time the last is kept.
Keys keysOf(const CameraPath& path) {
  Keys keys;
  glm::quat before(1, 0, 0, 0);
  for (std::size_t i = 0; i < path.poses.size(); ++i) {
    const auto timeOf = [&](std::size_t pose) {
      return static_cast<float>(path.poses[pose].time - path.poses.front().time);
    };
    if (i + 1 < path.poses.size() && timeOf(i + 1) <= timeOf(i)) continue;
    const glm::vec3& p = path.poses[i].pose.position;
    glm::quat q = glm::normalize(path.poses[i].pose.world_from_camera_rotation);
    // Viewers that do not go the short way by themselves would turn round once.
    if (!keys.times.empty() && glm::dot(q, before) < 0) q = -q;
    before = q;
    keys.times.push_back(timeOf(i));
    keys.translations.insert(keys.translations.end(), {p.x, p.y, p.z});
    keys.rotations.insert(keys.rotations.end(), {q.x, q.y, q.z, q.w});
  }
  return keys;
}

/// The buffer in the making and what describes it.
class AccessorWriter {
 public:
  AccessorWriter(ordered_json& root, std::vector<std::uint8_t>& bytes)
      : root_(root), bytes_(bytes) {}

  int add(const std::vector<float>& values, const char* type, std::size_t components) {
    const std::size_t offset = bytes_.size();
    bytes_.resize(offset + 4 * values.size());
    std::memcpy(bytes_.data() + offset, values.data(), 4 * values.size());
    const int view = addBufferView(root_, offset, 4 * values.size(), 0, 0);
    root_["accessors"].push_back({{"bufferView", view},
                                  {"componentType", kFloat},
                                  {"count", values.size() / components},
                                  {"type", type}});
    return static_cast<int>(root_["accessors"].size()) - 1;
  }

 private:
  ordered_json& root_;
  std::vector<std::uint8_t>& bytes_;
};

ordered_json describe(const CameraPath& path, std::vector<std::uint8_t>& bytes) {
  const Keys keys = keysOf(path);
  ordered_json root;
  root["asset"] = {{"version", "2.0"}, {"generator", "Enfilade"}};
  root["scene"] = 0;
  root["scenes"] = {{{"nodes", {0}}}};
  ordered_json node{{"camera", 0}};
  if (!path.name.empty()) node["name"] = path.name;
  root["nodes"].push_back(std::move(node));
  root["cameras"].push_back(
      {{"type", "perspective"},
       {"perspective", {{"yfov", path.vertical_fov}, {"znear", kNear}, {"zfar", kFar}}}});
  AccessorWriter accessors(root, bytes);
  const int times = accessors.add(keys.times, "SCALAR", 1);
  root["accessors"][0]["min"] = {keys.times.front()};
  root["accessors"][0]["max"] = {keys.times.back()};
  const int translations = accessors.add(keys.translations, "VEC3", 3);
  const int rotations = accessors.add(keys.rotations, "VEC4", 4);
  ordered_json animation{{"name", "walk"}};
  const auto channel = [&](int output, const char* property) {
    const std::size_t sampler = animation["samplers"].size();
    animation["samplers"].push_back(
        {{"input", times}, {"output", output}, {"interpolation", "LINEAR"}});
    animation["channels"].push_back(
        {{"sampler", sampler}, {"target", {{"node", 0}, {"path", property}}}});
  };
  channel(translations, "translation");
  channel(rotations, "rotation");
  root["animations"].push_back(std::move(animation));
  root["buffers"].push_back({{"byteLength", bytes.size()}});
  return root;
}

std::string dataUri(const std::vector<std::uint8_t>& bytes) {
  constexpr int kVariant = sodium_base64_VARIANT_ORIGINAL;
  std::string text(sodium_base64_encoded_len(bytes.size(), kVariant), '\0');
  sodium_bin2base64(text.data(), text.size(), bytes.data(), bytes.size(), kVariant);
  text.pop_back();  // the zero at its end
  return "data:application/octet-stream;base64," + text;
}

std::string textOf(const ordered_json& root, int indent) {
  return root.dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace

void writeGltfPath(const std::string& file, const CameraPath& path) {
  assert(!path.poses.empty());
  std::vector<std::uint8_t> bytes;
  ordered_json root = describe(path, bytes);
  if (std::filesystem::path(file).extension() == ".gltf") {
    root["buffers"][0]["uri"] = dataUri(bytes);
    writeFileAtomically(file, textOf(root, 1) + "\n");
    return;
  }
  GlbBuffer buffer;
  buffer.add(bytes);
  writeFileAtomically(file, buffer.encode(textOf(root, -1), file));
}

}  // namespace enfilade
