#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "scene/warning_log.h"

namespace enfilade {

/// The bytes of a glTF's buffers and images, wherever they stand: the GLB's binary chunk, data
/// URIs, or files in the model's own folder (symbolic links and percent-encoding resolved).
class GltfResources {
 public:
  /// Finds all that `root` names, and replaces every URI in it by a key for find().  `bin` must
  /// outlive this.  An image that is missing is a warning.  Throws Error (kBadInput): a buffer is
  /// missing or too short, a file lies outside the model's folder, files are named so often that
  /// they are many times their size.
  GltfResources(const std::string& model_file, std::span<const std::uint8_t> bin,
                nlohmann::json& root, WarningLog& warnings);

  /// Null if there is none of that key.
  const std::span<const std::uint8_t>* find(const std::string& key) const;

 private:
  std::span<const std::uint8_t> load(const std::string& uri);
  void takeBuffers(std::span<const std::uint8_t> bin, nlohmann::json& root);
  void takeImages(nlohmann::json& root, WarningLog& warnings);

  std::string model_file_;
  std::deque<std::vector<std::uint8_t>> owned_;
  std::map<std::string, std::span<const std::uint8_t>> by_file_;  ///< each read once
  std::uint64_t owned_bytes_ = 0, named_bytes_ = 0;
  std::map<std::string, std::span<const std::uint8_t>> by_key_;
};

}  // namespace enfilade
