#include "scene/gltf_accessors.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cassert>

#include "scene/gltf_elements.h"

namespace enfilade {
namespace {

const tinygltf::Accessor& accessorAt(const GltfModel& gltf, int accessor) {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= gltf->accessors.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no accessor {}", accessor));
  }
  return gltf->accessors[static_cast<std::size_t>(accessor)];
}

/// Where an accessor's elements lie: nowhere if it has no buffer view.
GltfElements locate(const GltfModel& gltf, int index, int components) {
  const tinygltf::Accessor& accessor = accessorAt(gltf, index);
  if (accessorComponents(gltf, index) != components) {
    gltf.fail(fmt::format("is no valid glTF: accessor {} has {} components where {} belong", index,
                          accessorComponents(gltf, index), components));
  }
  GltfElements elements{.count = accessor.count,
                        .component_type = accessor.componentType,
                        .components = components,
                        .normalized = accessor.normalized};
  componentSize(gltf, elements.component_type);
  if (accessor.bufferView < 0) return elements;  // all zeros
  if (static_cast<std::size_t>(accessor.bufferView) < gltf->bufferViews.size()) {
    elements.stride = gltf->bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
  }
  placeElements(gltf, accessor.bufferView, accessor.byteOffset, elements);
  return elements;
}

/// Puts a sparse accessor's values into `out`, which holds its base.
template <typename Number>
void applySparse(const GltfModel& gltf, const tinygltf::Accessor& accessor, GltfElements elements,
                 Number* out) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count ||
      sparse.indices.byteOffset < 0 || sparse.values.byteOffset < 0) {
    gltf.fail("is no valid glTF: a sparse accessor of impossible size");
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  GltfElements positions{
      .count = count, .component_type = sparse.indices.componentType, .components = 1};
  placeElements(gltf, sparse.indices.bufferView,
                static_cast<std::size_t>(sparse.indices.byteOffset), positions);
  std::vector<std::uint32_t> targets(count);
  convertElements(gltf, positions, targets.data());

  elements.count = count;
  elements.stride = 0;
  placeElements(gltf, sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                elements);
  const auto components = static_cast<std::size_t>(elements.components);
  std::vector<Number> values(count * components);
  convertElements(gltf, elements, values.data());
  for (std::size_t i = 0; i < count; ++i) {
    if (targets[i] >= accessor.count) {
      gltf.fail("is no valid glTF: a sparse accessor's index is out of range");
    }
    std::copy_n(values.data() + i * components, components, out + targets[i] * components);
  }
}

/// An accessor's elements of `components` numbers each, as `Element`s that hold nothing else.
template <typename Number, typename Element>
std::vector<Element> readAll(const GltfModel& gltf, int index, int components) {
  assert(sizeof(Element) == sizeof(Number) * static_cast<std::size_t>(components));
  const GltfElements elements = locate(gltf, index, components);
  gltf.countElements(elements.count);
  std::vector<Element> out(elements.count, Element(0));
  auto* numbers = reinterpret_cast<Number*>(out.data());
  if (elements.data != nullptr) convertElements(gltf, elements, numbers);
  const tinygltf::Accessor& accessor = accessorAt(gltf, index);
  if (accessor.sparse.isSparse) applySparse(gltf, accessor, elements, numbers);
  return out;
}

}  // namespace

std::size_t accessorCount(const GltfModel& gltf, int accessor) {
  return accessorAt(gltf, accessor).count;
}

int accessorComponents(const GltfModel& gltf, int accessor) {
  return tinygltf::GetNumComponentsInType(
      static_cast<std::uint32_t>(accessorAt(gltf, accessor).type));
}

std::vector<float> readScalars(const GltfModel& gltf, int accessor) {
  return readAll<float, float>(gltf, accessor, 1);
}
std::vector<glm::vec2> readVec2s(const GltfModel& gltf, int accessor) {
  return readAll<float, glm::vec2>(gltf, accessor, 2);
}
std::vector<glm::vec3> readVec3s(const GltfModel& gltf, int accessor) {
  return readAll<float, glm::vec3>(gltf, accessor, 3);
}
std::vector<glm::vec4> readVec4s(const GltfModel& gltf, int accessor) {
  return readAll<float, glm::vec4>(gltf, accessor, 4);
}
std::vector<std::uint32_t> readIndices(const GltfModel& gltf, int accessor) {
  return readAll<std::uint32_t, std::uint32_t>(gltf, accessor, 1);
}

}  // namespace enfilade
