#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "scene/warning_log.h"

namespace tinygltf {
class Model;
}

namespace enfilade {

/// A glTF file as tinygltf gives it, with what tinygltf loses.
struct GltfModel {
  std::string file;  ///< for errors
  std::shared_ptr<tinygltf::Model> model;
  std::vector<std::string> node_extras;  ///< a node's extras.enfilade as JSON text, or empty
  std::string extras;                    ///< the root's extras.enfilade as JSON text, or empty

  const tinygltf::Model& operator*() const { return *model; }
  const tinygltf::Model* operator->() const { return model.get(); }
  [[noreturn]] void fail(const std::string& reason) const;  ///< throws Error (kBadInput)
};

/// Reads a .glb or .gltf with all its buffers; tinygltf::Image::image holds the encoded file of
/// each image that has one.  Nothing that stands in the JSON as an index has been checked, but for
/// what parseGltfContainer and GltfResources say.  Throws Error (kBadInput).
GltfModel loadGltfModel(const std::string& file, WarningLog& warnings);

/// The same of a file's bytes; files that it names are sought beside `file`.
GltfModel parseGltfModel(std::span<const std::uint8_t> bytes, const std::string& file,
                         WarningLog& warnings);

}  // namespace enfilade
