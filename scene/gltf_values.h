#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace enfilade {

/// Throws Error (kBadInput), naming the place, for an index, an offset or a count in a glTF that is
/// no whole number of 0 or more, and for a vector or a list of indices that is none: tinygltf takes
/// 0 or nothing instead, and would show another picture.
/// Source: Khronos, glTF 2.0 specification, section 5.
void requireSoundGltfValues(const std::string& file, const nlohmann::json& root);

}  // namespace enfilade
