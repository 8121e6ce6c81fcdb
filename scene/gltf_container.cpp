#include "scene/gltf_container.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string_view>

#include "scene/error.h"
#include "scene/file_format.h"
#include "scene/gltf_values.h"
#include "scene/json_depth.h"

namespace enfilade {
namespace {

using nlohmann::json;

constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinChunk = 0x004e4942;

[[noreturn]] void fail(const std::string& file, const std::string& reason) {
  throw Error(ErrorKind::kBadInput, file, reason);
}

std::uint32_t readU32(std::span<const std::uint8_t> bytes, std::size_t offset) {
  return static_cast<std::uint32_t>(bytes[offset]) |
         static_cast<std::uint32_t>(bytes[offset + 1]) << 8 |
         static_cast<std::uint32_t>(bytes[offset + 2]) << 16 |
         static_cast<std::uint32_t>(bytes[offset + 3]) << 24;
}

std::string_view asText(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The chunk of `type` that begins at `offset`; moves `offset` behind it.
std::span<const std::uint8_t> takeChunk(const std::string& file,
                                        std::span<const std::uint8_t> bytes, std::size_t& offset,
                                        std::uint32_t& type) {
  if (bytes.size() - offset < 8) fail(file, "is truncated: a chunk header is cut short");
  const std::size_t length = readU32(bytes, offset);
  type = readU32(bytes, offset + 4);
  offset += 8;
  if (length > bytes.size() - offset) {
    fail(file, fmt::format("is damaged: a chunk says that it has {} bytes, {} are left", length,
                           bytes.size() - offset));
  }
  const auto chunk = bytes.subspan(offset, length);
  offset = std::min(bytes.size(), offset + (length + 3) / 4 * 4);
  return chunk;
}

std::string_view splitGlb(const std::string& file, std::span<const std::uint8_t> bytes,
                          std::span<const std::uint8_t>& bin) {
  if (bytes.size() < 20) fail(file, fmt::format("is truncated: {} bytes", bytes.size()));
  const std::uint32_t version = readU32(bytes, 4);
  if (version != 2) {
    fail(file,
         fmt::format("is a GLB of version {}; version 2 is needed (export as glTF 2.0)", version));
  }
  const std::uint32_t length = readU32(bytes, 8);
  if (length > bytes.size()) {
    fail(file, fmt::format("is truncated: {} of {} bytes are there", bytes.size(), length));
  }
  if (length < 20) fail(file, "is damaged: its header gives a length that is too small");
  bytes = bytes.first(length);

  std::size_t offset = 12;
  std::uint32_t type = 0;
  const auto json_chunk = takeChunk(file, bytes, offset, type);
  if (type != kJsonChunk) fail(file, "is damaged: its first chunk is not JSON");
  while (offset < bytes.size()) {
    const auto chunk = takeChunk(file, bytes, offset, type);
    if (type == kBinChunk) {
      bin = chunk;
      break;
    }
  }
  return asText(json_chunk);
}

json parseJson(const std::string& file, std::string_view text) {
  requireShallowJson(text, file);
  try {
    return json::parse(text);
  } catch (const json::exception& e) {
    // "[json.exception.parse_error.101] parse error at line 1, column 9: …"
    const std::string what = e.what();
    const std::size_t end = what.find("] ");
    fail(file, "is not valid JSON: " +
                   oneLine(end == std::string::npos ? what : what.substr(end + 2), 160));
  }
}

void checkShape(const std::string& file, const json& root) {
  if (!root.is_object()) fail(file, "is not a glTF file: its JSON is no object");
  const auto asset = root.find("asset");
  if (asset == root.end() || !asset->is_object() || !asset->contains("version") ||
      !(*asset)["version"].is_string()) {
    fail(file, "is JSON but not glTF: asset.version is missing");
  }
  // A minimum is given by a file that must not be read as what its version says.
  const auto least = asset->find("minVersion");
  const bool has_least = least != asset->end() && least->is_string();
  const std::string version = (*asset)["version"], needed = has_least ? *least : "2.0";
  if (!version.starts_with("2.") || needed != "2.0") {
    fail(file, fmt::format("is glTF {}; version 2.0 is needed",
                           oneLine(has_least ? needed : version, 20)));
  }
  for (const char* key : {"accessors", "animations", "buffers", "bufferViews", "cameras", "images",
                          "materials", "meshes", "nodes", "samplers", "scenes", "skins", "textures",
                          "extensionsRequired", "extensionsUsed"}) {
    if (root.contains(key) && !root[key].is_array()) {
      fail(file, fmt::format("is no valid glTF: \"{}\" is not an array", key));
    }
  }
}

void checkRequiredExtensions(const std::string& file, const json& root) {
  constexpr std::array<std::string_view, 4> kKnown{"KHR_lights_punctual", "KHR_materials_unlit",
                                                   "KHR_mesh_quantization",
                                                   "KHR_texture_transform"};
  std::string lacking;
  for (const json& extension : root.value("extensionsRequired", json::array())) {
    if (!extension.is_string()) continue;
    const auto& name = extension.get_ref<const std::string&>();
    if (std::find(kKnown.begin(), kKnown.end(), name) != kKnown.end()) continue;
    lacking += (lacking.empty() ? "" : ", ") + oneLine(name);
  }
  if (lacking.empty()) return;
  fail(file, "requires the glTF extension " + lacking +
                 ", which is not supported; export it without (no mesh or texture compression)");
}

}  // namespace

bool isGlb(std::span<const std::uint8_t> bytes) noexcept {
  return bytes.size() >= 4 && std::memcmp(bytes.data(), "glTF", 4) == 0;
}

json parseGltfContainer(const std::string& file, std::span<const std::uint8_t> bytes,
                        std::span<const std::uint8_t>& bin, WarningLog& warnings) {
  bin = {};
  std::string_view text;
  if (isGlb(bytes)) {
    text = splitGlb(file, bytes, bin);
  } else {
    text = asText(bytes);
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
    if (text.empty()) fail(file, "is empty");
    const std::size_t start = text.find_first_not_of(" \t\r\n");
    if (start == std::string_view::npos || text[start] != '{') {
      fail(file, "is not a glTF file (neither GLB nor JSON): " + guessFormat(bytes));
    }
  }
  json root = parseJson(file, text);
  checkShape(file, root);
  requireSoundGltfValues(file, root);
  checkRequiredExtensions(file, root);
  const json used = root.value("extensionsUsed", json::array());
  for (const char* ignored : {"EXT_mesh_gpu_instancing", "KHR_node_visibility"}) {
    if (std::find(used.begin(), used.end(), json(ignored)) != used.end()) {
      warnings.add("extension ignored", ignored);
    }
  }
  return root;
}

}  // namespace enfilade
