#pragma once

#include <cstddef>
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

  /// Of all buffers, and of all images that are files of their own.
  std::size_t byteCount() const;

  /// Takes note that so many elements are read.  A file may name the same ones, or ones that are
  /// all zero, again and again: throws Error (kBadInput) for far more than its buffers' size is
  /// reason for.
  void countElements(std::size_t count) const;

 private:
  mutable std::size_t elements_ = 0;
};

/// Reads the bytes of a .glb or .gltf, and all its buffers, which `file` may lie beside;
/// tinygltf::Image::image holds the encoded file of each image that has one.  Nothing that stands
/// in the JSON as an index has been checked, but for what parseGltfContainer and GltfResources say.
/// Throws Error (kBadInput).
GltfModel loadGltfModel(std::span<const std::uint8_t> bytes, const std::string& file,
                        WarningLog& warnings);

}  // namespace enfilade
