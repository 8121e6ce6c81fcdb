#include "scene/gltf_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "scene/error.h"

namespace enfilade {
namespace {

using nlohmann::json;

/// The values of one object of a glTF, by the place that it has there.
class Values {
 public:
  /// All of a glTF.
  Values(const std::string& file, const json& root) : file_(file), object_(root) {}

  void requireWhole(std::initializer_list<const char*> keys) const {
    for (const char* key : keys) {
      const json* value = find(key);
      if (value != nullptr && !isWhole(*value)) fail(at(key), "is no whole number of 0 or more");
    }
  }

  void requireIndex(std::initializer_list<const char*> keys) const {
    for (const char* key : keys) {
      const json* value = find(key);
      if (value != nullptr && !isIndex(*value)) fail(at(key), "is no index");
    }
  }

  void requireIndices(const char* key) const {
    const json* value = find(key);
    if (value == nullptr) return;
    const bool sound = value->is_array() && std::all_of(value->begin(), value->end(), isIndex);
    if (!sound) fail(at(key), "is no list of indices");
  }

  void requireNumbers(std::initializer_list<const char*> keys) const {
    const auto is_number = [](const json& value) { return value.is_number(); };
    for (const char* key : keys) {
      const json* value = find(key);
      if (value == nullptr) continue;
      const bool sound = value->is_array() && std::all_of(value->begin(), value->end(), is_number);
      if (!sound) fail(at(key), "is no list of numbers");
    }
  }

  /// Calls `check` for the object of that name, if there is one.
  template <typename Check>
  void within(const char* key, Check&& check) const {
    if (const json* value = find(key)) check(Values(*this, key, kNoList, *value));
  }

  /// Calls `check` for each object of the list of that name.
  template <typename Check>
  void each(const char* key, Check&& check) const {
    const json* list = find(key);
    if (list == nullptr) return;
    if (!list->is_array()) fail(at(key), "is no list");
    for (std::size_t i = 0; i < list->size(); ++i) {
      check(Values(*this, key, i, (*list)[i]));
    }
  }

 private:
  static constexpr std::size_t kNoList = static_cast<std::size_t>(-1);

  /// Of what `key` of `owner` is, or the one of that `number` there.
  Values(const Values& owner, const char* key, std::size_t number, const json& object)
      : file_(owner.file_), owner_(&owner), key_(key), number_(number), object_(object) {
    if (!object_.is_object()) fail(place(), "is no object");
  }

  static bool isWhole(const json& value) { return value.is_number_unsigned(); }
  /// Some exporters write −1 for none.
  static bool isIndex(const json& value) { return isWhole(value) || value == -1; }

  const json* find(const char* key) const {
    const auto found = object_.find(key);
    return found == object_.end() || found->is_null() ? nullptr : &*found;
  }

  /// Told only of what is wrong: there may be millions.
  std::string place() const {
    if (owner_ == nullptr) return {};
    return owner_->at(key_) + (number_ == kNoList ? "" : fmt::format("[{}]", number_));
  }
  std::string at(const char* key) const { return owner_ == nullptr ? key : place() + "." + key; }

  [[noreturn]] void fail(const std::string& place, const std::string& reason) const {
    throw Error(ErrorKind::kBadInput, file_, "is no valid glTF: " + place + " " + reason);
  }

  const std::string& file_;
  const Values* owner_ = nullptr;
  const char* key_ = nullptr;
  std::size_t number_ = kNoList;
  const json& object_;
};

}  // namespace

void requireSoundGltfValues(const std::string& file, const json& root) {
  const Values gltf(file, root);
  gltf.requireIndex({"scene"});
  gltf.each("scenes", [](const Values& scene) { scene.requireIndices("nodes"); });
  gltf.each("nodes", [](const Values& node) {
    node.requireIndex({"mesh", "camera", "skin"});
    node.requireIndices("children");
    node.requireNumbers({"matrix", "translation", "rotation", "scale"});
  });
  gltf.each("meshes", [](const Values& mesh) {
    mesh.each("primitives", [](const Values& part) {
      part.requireIndex({"indices", "material"});
      part.requireWhole({"mode"});
    });
  });
  gltf.each("accessors", [](const Values& accessor) {
    accessor.requireIndex({"bufferView"});
    accessor.requireWhole({"byteOffset", "componentType", "count"});
  });
  gltf.each("bufferViews", [](const Values& view) {
    view.requireIndex({"buffer"});
    view.requireWhole({"byteOffset", "byteLength", "byteStride"});
  });
  gltf.each("buffers", [](const Values& buffer) { buffer.requireWhole({"byteLength"}); });
  gltf.each("images", [](const Values& image) { image.requireIndex({"bufferView"}); });
  gltf.each("textures", [](const Values& texture) { texture.requireIndex({"source", "sampler"}); });
  gltf.each("materials", [](const Values& material) {
    material.within("pbrMetallicRoughness", [](const Values& surface) {
      surface.requireNumbers({"baseColorFactor"});
      surface.within("baseColorTexture", [](const Values& texture) {
        texture.requireIndex({"index"});
        texture.requireWhole({"texCoord"});
      });
    });
  });
}

}  // namespace enfilade
