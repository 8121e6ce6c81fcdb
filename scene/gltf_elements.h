#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "scene/gltf_model.h"

namespace enfilade {

/// Elements in a buffer, proved to lie inside it by placeElements.
struct GltfElements {
  const std::uint8_t* data = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;  ///< bytes from one to the next
  int component_type = 0;
  int components = 0;
  bool normalized = false;
};

/// The bytes of a component.  Throws Error (kBadInput) for a type that glTF has not.
std::size_t componentSize(const GltfModel& gltf, int component_type);

/// The bytes of a buffer view.  Throws Error (kBadInput) if it is not wholly there.
std::span<const std::uint8_t> bufferViewBytes(const GltfModel& gltf, int buffer_view);

/// Points `elements` at `byte_offset` of a buffer view; 0 as its stride means tightly packed.
/// Throws Error (kBadInput) if they do not lie inside it.
void placeElements(const GltfModel& gltf, int buffer_view, std::size_t byte_offset,
                   GltfElements& elements);

/// Converts all components of all elements.  `out` has room for components · count numbers.
void convertElements(const GltfModel& gltf, const GltfElements& elements, float* out);

/// The same for unsigned integers.  Throws Error (kBadInput) for components of another type.
void convertElements(const GltfModel& gltf, const GltfElements& elements, std::uint32_t* out);

}  // namespace enfilade
