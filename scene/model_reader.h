#pragma once

#include <string>

#include "scene/gltf_reader.h"

namespace enfilade {

/// Reads a model by its content, whatever the extension: glTF or GLB (see readGltf()), or Wavefront
/// OBJ (see readObj()).  Throws Error (kBadInput).
Building readModel(const std::string& file, Warnings* warnings = nullptr);

}  // namespace enfilade
