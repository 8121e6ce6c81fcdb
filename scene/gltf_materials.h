#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "scene/building.h"
#include "scene/gltf_model.h"

namespace enfilade {

/// Which texture coordinates a material samples its picture by.
struct TextureMapping {
  int texcoord_set = 0;
  /// u' = m[0]·u + m[1]·v + m[2], v' = m[3]·u + m[4]·v + m[5]
  std::array<float, 6> transform{1, 0, 0, 0, 1, 0};
  auto operator<=>(const TextureMapping&) const = default;
};

/// Reads all materials of `gltf`, in their order, into building.materials and the pictures that
/// they use into building.images.  A picture that cannot be decoded is left out with a warning.
/// Returns one mapping a material.
std::vector<TextureMapping> readMaterials(const GltfModel& gltf, Building& building,
                                          WarningLog& warnings);

}  // namespace enfilade
