#include "scene/gltf_elements.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace enfilade {
namespace {

/// Components as floats: normalized integers mapped to −1…1 or 0…1.
template <typename T>
struct ToFloat {
  bool normalized = false;
  float operator()(T value) const {
    const auto f = static_cast<float>(value);
    if constexpr (std::is_floating_point_v<T>) return f;
    return normalized ? std::max(f / static_cast<float>(std::numeric_limits<T>::max()), -1.0f) : f;
  }
};

template <typename T, typename Number, typename Convert>
void convertAll(const GltfElements& elements, Number* out, const Convert& to_number) {
  const auto components = static_cast<std::size_t>(elements.components);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      T value;
      std::memcpy(&value, elements.data + i * elements.stride + c * sizeof(T), sizeof(T));
      *out++ = to_number(value);
    }
  }
}

template <typename T>
void convertToFloat(const GltfElements& elements, float* out) {
  convertAll<T>(elements, out, ToFloat<T>{elements.normalized});
}

template <typename T>
void convertToU32(const GltfElements& elements, std::uint32_t* out) {
  convertAll<T>(elements, out, [](T value) { return static_cast<std::uint32_t>(value); });
}

}  // namespace

std::size_t componentSize(const GltfModel& gltf, int component_type) {
  switch (component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      gltf.fail(fmt::format("is no valid glTF: component type {}", component_type));
  }
}

std::span<const std::uint8_t> bufferViewBytes(const GltfModel& gltf, int buffer_view) {
  if (buffer_view < 0 || static_cast<std::size_t>(buffer_view) >= gltf->bufferViews.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no buffer view {}", buffer_view));
  }
  const tinygltf::BufferView& view = gltf->bufferViews[static_cast<std::size_t>(buffer_view)];
  if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= gltf->buffers.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no buffer {}", view.buffer));
  }
  const std::vector<unsigned char>& data =
      gltf->buffers[static_cast<std::size_t>(view.buffer)].data;
  if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
    gltf.fail(fmt::format("is damaged: buffer view {} reaches beyond the end of its buffer",
                          buffer_view));
  }
  return std::span(data).subspan(view.byteOffset, view.byteLength);
}

void placeElements(const GltfModel& gltf, int buffer_view, std::size_t byte_offset,
                   GltfElements& elements) {
  const auto bytes = bufferViewBytes(gltf, buffer_view);
  const std::size_t size =
      componentSize(gltf, elements.component_type) * static_cast<std::size_t>(elements.components);
  if (elements.stride == 0) elements.stride = size;
  const bool fits = elements.count == 0 ||
                    (byte_offset <= bytes.size() && size <= bytes.size() - byte_offset &&
                     elements.count - 1 <= (bytes.size() - byte_offset - size) / elements.stride);
  if (!fits) {
    gltf.fail(fmt::format("is damaged: {} elements reach beyond the end of buffer view {}",
                          elements.count, buffer_view));
  }
  elements.data = bytes.data() + byte_offset;
}

void convertElements(const GltfModel&, const GltfElements& elements, float* out) {
  switch (elements.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return convertToFloat<std::int8_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return convertToFloat<std::uint8_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return convertToFloat<std::int16_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return convertToFloat<std::uint16_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return convertToFloat<std::uint32_t>(elements, out);
    default:
      return convertToFloat<float>(elements, out);
  }
}

void convertElements(const GltfModel& gltf, const GltfElements& elements, std::uint32_t* out) {
  switch (elements.component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return convertToU32<std::uint8_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return convertToU32<std::uint16_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return convertToU32<std::uint32_t>(elements, out);
    default:
      gltf.fail("is no valid glTF: indices that are not unsigned integers");
  }
}

}  // namespace enfilade
