#include "scene/gltf_model.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "scene/error.h"
#include "scene/gltf_container.h"
#include "scene/gltf_resources.h"
#include "scene/short_name.h"

namespace enfilade {
namespace {

using nlohmann::json;

const GltfResources& resourcesOf(void* user_data) {
  return *static_cast<const GltfResources*>(user_data);
}

bool resourceExists(const std::string& key, void* user_data) {
  return resourcesOf(user_data).find(key) != nullptr;
}

std::string sameKey(const std::string& key, void*) { return key; }

bool readResource(std::vector<unsigned char>* out, std::string*, const std::string& key,
                  void* user_data) {
  const auto* bytes = resourcesOf(user_data).find(key);
  if (bytes == nullptr) return false;
  out->assign(bytes->begin(), bytes->end());
  return true;
}

bool writeNothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
  return false;
}

/// Keeps the encoded file.  tinygltf does not check that an image's buffer view lies in its buffer,
/// so those are fetched later.
bool keepEncoded(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                 const unsigned char* bytes, int size, void*) {
  if (image->bufferView < 0) image->image.assign(bytes, bytes + size);
  return true;
}

/// tinygltf's first complaint, in one line.
std::string firstLine(const std::string& text) {
  const std::string line = text.substr(0, text.find('\n'));
  return line.empty() ? "is no valid glTF" : "is no valid glTF: " + oneLine(line, 160);
}

std::string enfiladeExtras(const json& o) {
  if (!o.is_object()) return {};
  const auto extras = o.find("extras");
  if (extras == o.end() || !extras->is_object()) return {};
  const auto ours = extras->find("enfilade");
  return ours == extras->end() ? std::string() : ours->dump();
}

std::shared_ptr<tinygltf::Model> parseByTinyGltf(const std::string& file, const std::string& text,
                                                 GltfResources& resources, WarningLog& warnings) {
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks({resourceExists, sameKey, readResource, writeNothing, &resources});
  loader.SetImageLoader(keepEncoded, nullptr);
  auto model = std::make_shared<tinygltf::Model>();
  std::string errors;
  std::string ignored;
  bool ok = false;
  try {
    ok = loader.LoadASCIIFromString(model.get(), &errors, &ignored, text.data(),
                                    static_cast<unsigned int>(text.size()), "");
  } catch (const std::exception& e) {
    errors += e.what();
  }
  if (!ok) throw Error(ErrorKind::kBadInput, file, firstLine(errors));
  if (!errors.empty()) warnings.add("glTF that breaks the rules", firstLine(errors));
  return model;
}

}  // namespace

std::size_t GltfModel::byteCount() const {
  std::size_t bytes = 0;
  for (const tinygltf::Buffer& buffer : model->buffers) bytes += buffer.data.size();
  for (const tinygltf::Image& image : model->images) bytes += image.image.size();
  return bytes;
}

void GltfModel::countElements(std::size_t count) const {
  constexpr std::size_t kAlways = std::size_t{1} << 22;
  constexpr std::size_t kEachByte = 16;
  const std::size_t bytes = byteCount();
  const std::size_t most = kAlways + kEachByte * bytes;
  if (count > most || elements_ > most - count) {
    fail(fmt::format("names over {} vertices and corners, far more than its {} bytes hold", most,
                     bytes));
  }
  elements_ += count;
}

void GltfModel::fail(const std::string& reason) const {
  throw Error(ErrorKind::kBadInput, file, reason);
}

GltfModel loadGltfModel(std::span<const std::uint8_t> bytes, const std::string& file,
                        WarningLog& warnings) {
  std::span<const std::uint8_t> bin;
  json root = parseGltfContainer(file, bytes, bin, warnings);
  GltfResources resources(file, bin, root, warnings);

  GltfModel result;
  result.file = file;
  result.extras = enfiladeExtras(root);
  if (root.contains("nodes")) {
    for (const json& node : root["nodes"]) result.node_extras.push_back(enfiladeExtras(node));
  }
  const std::string text = root.dump();
  root = nullptr;
  if (text.size() > std::numeric_limits<unsigned int>::max()) result.fail("has over 4 GiB of JSON");
  result.model = parseByTinyGltf(file, text, resources, warnings);
  for (tinygltf::Node& node : result.model->nodes) shortenName(node.name);
  for (tinygltf::Mesh& mesh : result.model->meshes) shortenName(mesh.name);
  for (tinygltf::Material& material : result.model->materials) shortenName(material.name);
  for (tinygltf::Image& image : result.model->images) shortenName(image.name);
  return result;
}

}  // namespace enfilade
