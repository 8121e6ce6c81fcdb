#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "scene/warning_log.h"

namespace enfilade {

/// Whether `bytes` begin as a GLB does.
bool isGlb(std::span<const std::uint8_t> bytes) noexcept;

/// The JSON of a .glb or .gltf, checked: GLB header and chunks, glTF version 2, nested no deeper
/// than 100, arrays where glTF has arrays, no required extension that we lack.  `bin` becomes the
/// binary chunk, a part of `bytes`, or empty.  Throws Error (kBadInput) that names `file`.
/// Source: Khronos, glTF 2.0 specification, sections 3.2, 3.12 and 4.4.
nlohmann::json parseGltfContainer(const std::string& file, std::span<const std::uint8_t> bytes,
                                  std::span<const std::uint8_t>& bin, WarningLog& warnings);

}  // namespace enfilade
