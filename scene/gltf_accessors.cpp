#include "scene/gltf_accessors.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <type_traits>

namespace enfilade {
namespace {

/// An accessor without a buffer view is all zeros: nothing in the file bounds its length.
constexpr std::size_t kMaxZeroElements = std::size_t{1} << 24;

/// Elements in a buffer, proved to lie inside it.
struct Elements {
  const std::uint8_t* data = nullptr;
  std::size_t count = 0;
  std::size_t stride = 0;  ///< bytes from one to the next
  int component_type = 0;
  int components = 0;
  bool normalized = false;
};

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

const tinygltf::Accessor& accessorAt(const GltfModel& gltf, int accessor) {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= gltf->accessors.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no accessor {}", accessor));
  }
  return gltf->accessors[static_cast<std::size_t>(accessor)];
}

/// Points `elements` at `byte_offset` of a buffer view; 0 as its stride means tightly packed.
void place(const GltfModel& gltf, int buffer_view, std::size_t byte_offset, Elements& elements) {
  const auto bytes = bufferViewBytes(gltf, buffer_view);
  const std::size_t size =
      componentSize(gltf, elements.component_type) * static_cast<std::size_t>(elements.components);
  if (elements.stride == 0) elements.stride = size;
  const bool fits = byte_offset <= bytes.size() && size <= bytes.size() - byte_offset &&
                    (elements.count - 1) <= (bytes.size() - byte_offset - size) / elements.stride;
  if (elements.count > 0 && !fits) {
    gltf.fail(fmt::format("is damaged: {} elements reach beyond the end of buffer view {}",
                          elements.count, buffer_view));
  }
  elements.data = bytes.data() + byte_offset;
}

template <typename T>
float toFloat(T value, bool normalized) {
  if constexpr (std::is_floating_point_v<T>) {
    return value;
  } else {
    const float f = static_cast<float>(value);
    if (!normalized) return f;
    return std::max(f / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
  }
}

template <typename T>
void convert(const Elements& elements, float* out) {
  const auto components = static_cast<std::size_t>(elements.components);
  for (std::size_t i = 0; i < elements.count; ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      T value;
      std::memcpy(&value, elements.data + i * elements.stride + c * sizeof(T), sizeof(T));
      *out++ = toFloat(value, elements.normalized);
    }
  }
}

void convert(const Elements& elements, float* out) {
  switch (elements.component_type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return convert<std::int8_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return convert<std::uint8_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return convert<std::int16_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return convert<std::uint16_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return convert<std::uint32_t>(elements, out);
    default:
      return convert<float>(elements, out);
  }
}

template <typename T>
void copyIndices(const Elements& elements, std::uint32_t* out) {
  for (std::size_t i = 0; i < elements.count; ++i) {
    T value;
    std::memcpy(&value, elements.data + i * elements.stride, sizeof(T));
    out[i] = value;
  }
}

void copyIndices(const GltfModel& gltf, const Elements& elements, std::uint32_t* out) {
  switch (elements.component_type) {
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return copyIndices<std::uint8_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return copyIndices<std::uint16_t>(elements, out);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return copyIndices<std::uint32_t>(elements, out);
    default:
      gltf.fail("is no valid glTF: indices that are not unsigned integers");
  }
}

void convertAll(const GltfModel&, const Elements& elements, float* out) { convert(elements, out); }
void convertAll(const GltfModel& gltf, const Elements& elements, std::uint32_t* out) {
  copyIndices(gltf, elements, out);
}

/// Puts a sparse accessor's values into `out`, which holds its base.
template <typename Out>
void applySparse(const GltfModel& gltf, const tinygltf::Accessor& accessor, Elements elements,
                 std::vector<Out>& out) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
    gltf.fail("is no valid glTF: a sparse accessor of impossible size");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  Elements positions{
      .count = count, .component_type = sparse.indices.componentType, .components = 1};
  place(gltf, sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset),
        positions);
  std::vector<std::uint32_t> targets(count);
  copyIndices(gltf, positions, targets.data());

  elements.count = count;
  elements.stride = 0;
  place(gltf, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
        elements);
  const auto components = static_cast<std::size_t>(elements.components);
  std::vector<Out> values(count * components);
  convertAll(gltf, elements, values.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (targets[i] >= accessor.count) {
      gltf.fail("is no valid glTF: a sparse accessor's index is out of range");
    }
    std::copy_n(values.data() + i * components, components, out.data() + targets[i] * components);
  }
}

/// All components of all elements, element by element.
template <typename Out>
std::vector<Out> readAll(const GltfModel& gltf, int index, int components) {
  const tinygltf::Accessor& accessor = accessorAt(gltf, index);
  if (accessorComponents(gltf, index) != components) {
    gltf.fail(fmt::format("is no valid glTF: accessor {} has {} components where {} belong", index,
                          accessorComponents(gltf, index), components));
  }
  Elements elements{.count = accessor.count,
                    .component_type = accessor.componentType,
                    .components = components,
                    .normalized = accessor.normalized};
  if (accessor.bufferView < 0) {
    if (accessor.count > kMaxZeroElements) {
      gltf.fail(fmt::format("is no valid glTF: accessor {} has {} elements and no data", index,
                            accessor.count));
    }
    componentSize(gltf, elements.component_type);
  } else {
    if (static_cast<std::size_t>(accessor.bufferView) < gltf->bufferViews.size()) {
      elements.stride = gltf->bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    }
    place(gltf, accessor.bufferView, accessor.byteOffset, elements);
  }
  std::vector<Out> out(accessor.count * static_cast<std::size_t>(components));
  if (accessor.bufferView >= 0) convertAll(gltf, elements, out.data());
  if (accessor.sparse.isSparse) applySparse(gltf, accessor, elements, out);
  return out;
}

template <typename Vec>
std::vector<Vec> readVectors(const GltfModel& gltf, int accessor) {
  const std::vector<float> floats = readAll<float>(gltf, accessor, Vec::length());
  std::vector<Vec> out(floats.size() / static_cast<std::size_t>(Vec::length()));
  static_assert(sizeof(Vec) == sizeof(float) * static_cast<std::size_t>(Vec::length()));
  if (!out.empty()) std::memcpy(out.data(), floats.data(), floats.size() * sizeof(float));
  return out;
}

}  // namespace

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

std::size_t accessorCount(const GltfModel& gltf, int accessor) {
  return accessorAt(gltf, accessor).count;
}

int accessorComponents(const GltfModel& gltf, int accessor) {
  return tinygltf::GetNumComponentsInType(
      static_cast<std::uint32_t>(accessorAt(gltf, accessor).type));
}

std::vector<float> readScalars(const GltfModel& gltf, int accessor) {
  return readAll<float>(gltf, accessor, 1);
}
std::vector<glm::vec2> readVec2s(const GltfModel& gltf, int accessor) {
  return readVectors<glm::vec2>(gltf, accessor);
}
std::vector<glm::vec3> readVec3s(const GltfModel& gltf, int accessor) {
  return readVectors<glm::vec3>(gltf, accessor);
}
std::vector<glm::vec4> readVec4s(const GltfModel& gltf, int accessor) {
  return readVectors<glm::vec4>(gltf, accessor);
}
std::vector<std::uint32_t> readIndices(const GltfModel& gltf, int accessor) {
  return readAll<std::uint32_t>(gltf, accessor, 1);
}

}  // namespace enfilade
