#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "scene/gltf_model.h"

namespace enfilade {

/// Elements of an accessor.  Throws Error (kBadInput) if there is no such accessor.
std::size_t accessorCount(const GltfModel& gltf, int accessor);

/// Components of an accessor's elements: 3 for VEC3.  Throws as accessorCount does.
int accessorComponents(const GltfModel& gltf, int accessor);

/// An accessor's values, normalized integers mapped to −1…1 or 0…1, other integers converted, and
/// sparse values put in.  Throws Error (kBadInput): another number of components, outside its
/// buffer, a component type that glTF has not.
/// Source: Khronos, glTF 2.0 specification, section 3.6.2.
std::vector<float> readScalars(const GltfModel& gltf, int accessor);
std::vector<glm::vec2> readVec2s(const GltfModel& gltf, int accessor);
std::vector<glm::vec3> readVec3s(const GltfModel& gltf, int accessor);
std::vector<glm::vec4> readVec4s(const GltfModel& gltf, int accessor);

/// A scalar accessor of unsigned integers.  Throws Error (kBadInput).
std::vector<std::uint32_t> readIndices(const GltfModel& gltf, int accessor);

}  // namespace enfilade
