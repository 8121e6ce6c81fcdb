#include "scene/gltf_materials.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "scene/error.h"
#include "scene/gltf_elements.h"
#include "scene/picture_budget.h"

namespace enfilade {
namespace {

double numberOr(const tinygltf::Value& o, const std::string& key, double otherwise) {
  if (!o.IsObject() || !o.Has(key)) return otherwise;
  const tinygltf::Value& value = o.Get(key);
  return value.IsNumber() ? value.GetNumberAsDouble() : otherwise;
}

/// `count` numbers, or none.
std::vector<double> numbersOf(const tinygltf::Value& o, const std::string& key, std::size_t count) {
  std::vector<double> numbers;
  if (!o.IsObject() || !o.Has(key)) return numbers;
  const tinygltf::Value& values = o.Get(key);
  if (!values.IsArray() || values.ArrayLen() != count) return numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const tinygltf::Value& value = values.Get(static_cast<int>(i));
    numbers.push_back(value.IsNumber() ? value.GetNumberAsDouble() : 0.0);
  }
  return numbers;
}

/// What a material's colour comes from.
struct BaseColor {
  std::vector<double> factor;  ///< 4 numbers, or none
  tinygltf::TextureInfo texture;
};

/// From pbrMetallicRoughness, or from the diffuse part of KHR_materials_pbrSpecularGlossiness,
/// which older exporters write.
BaseColor baseColorOf(const tinygltf::Material& material) {
  const auto found = material.extensions.find("KHR_materials_pbrSpecularGlossiness");
  if (found == material.extensions.end()) {
    return {material.pbrMetallicRoughness.baseColorFactor,
            material.pbrMetallicRoughness.baseColorTexture};
  }
  BaseColor color{numbersOf(found->second, "diffuseFactor", 4), {}};
  if (!found->second.Has("diffuseTexture")) return color;
  const tinygltf::Value& texture = found->second.Get("diffuseTexture");
  color.texture.index = static_cast<int>(std::clamp(numberOr(texture, "index", -1), -1.0, 1e9));
  color.texture.texCoord = static_cast<int>(std::clamp(numberOr(texture, "texCoord", 0), 0.0, 1e3));
  if (texture.Has("extensions") && texture.Get("extensions").IsObject()) {
    color.texture.extensions = texture.Get("extensions").Get<tinygltf::Value::Object>();
  }
  return color;
}

/// The texture of a material's base colour; null without one.
const tinygltf::Texture* textureOf(const GltfModel& gltf, const tinygltf::Material& material) {
  const int index = baseColorOf(material).texture.index;
  if (index < 0) return nullptr;
  if (static_cast<std::size_t>(index) >= gltf->textures.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no texture {}", index));
  }
  return &gltf->textures[static_cast<std::size_t>(index)];
}

/// The pictures that materials use, in the file's order.
class ImageTable {
 public:
  ImageTable(const GltfModel& gltf, Building& building, WarningLog& warnings)
      : gltf_(gltf), building_(building), warnings_(warnings) {
    for (const tinygltf::Material& material : gltf->materials) {
      const tinygltf::Texture* texture = textureOf(gltf, material);
      if (texture != nullptr && texture->source >= 0) indices_[texture->source] = kNone;
    }
    for (auto& [gltf_image, index] : indices_) index = read(gltf_image);
  }

  /// The index in Building::images, or kNone.
  std::uint32_t indexOf(int gltf_image) const { return indices_.at(gltf_image); }

 private:
  std::uint32_t read(int gltf_image) {
    if (gltf_image < 0 || static_cast<std::size_t>(gltf_image) >= gltf_->images.size()) {
      gltf_.fail(fmt::format("is no valid glTF: there is no image {}", gltf_image));
    }
    const tinygltf::Image& source = gltf_->images[static_cast<std::size_t>(gltf_image)];
    TextureImage image;
    image.name = source.name;
    image.encoded = source.image;
    if (source.bufferView >= 0) {
      const auto bytes = bufferViewBytes(gltf_, source.bufferView);
      image.encoded.assign(bytes.begin(), bytes.end());
    }
    if (image.encoded.empty()) return kNone;  // missing: said by whoever looked for the file
    try {
      image.image =
          decodeImage(image.encoded, fmt::format("image {} '{}'", gltf_image, source.name));
    } catch (const Error& error) {
      warnings_.add("picture left out", oneLine(error.what(), 200));
      return kNone;
    }
    image.mime_type = imageMimeType(image.encoded);
    countPixels(image.image);
    building_.images.push_back(std::move(image));
    return static_cast<std::uint32_t>(building_.images.size() - 1);
  }

  void countPixels(const Image& image) {
    if (budget_.add(image.rgba.size() / 4, gltf_.byteCount())) return;
    gltf_.fail(fmt::format("has pictures of {} pixels, far more than its bytes can hold",
                           budget_.pixels()));
  }

  const GltfModel& gltf_;
  Building& building_;
  WarningLog& warnings_;
  std::map<int, std::uint32_t> indices_;
  PictureBudget budget_;
};

std::string quoted(const tinygltf::Material& material) {
  return "material '" + oneLine(material.name) + "'";
}

glm::vec4 colorOf(const std::vector<double>& factor) {
  glm::vec4 color(1);
  for (std::size_t i = 0; i < factor.size() && i < 4; ++i) {
    const bool finite = std::isfinite(factor[i]);
    color[static_cast<glm::length_t>(i)] =
        finite ? static_cast<float>(std::clamp(factor[i], 0.0, 1.0)) : 1.0f;
  }
  return color;
}

Wrap wrapOf(int gltf_wrap) {
  if (gltf_wrap == TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE) return Wrap::kClampToEdge;
  if (gltf_wrap == TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT) return Wrap::kMirroredRepeat;
  return Wrap::kRepeat;
}

/// KHR_texture_transform.  Its text turns counter-clockwise with v pointing down; the GLSL listed
/// there turns the other way (KhronosGroup/glTF issue 1563).  This is what its sample model and all
/// viewers do.
TextureMapping mappingOf(const tinygltf::TextureInfo& texture) {
  TextureMapping mapping;
  mapping.texcoord_set = texture.texCoord;
  const auto found = texture.extensions.find("KHR_texture_transform");
  if (found == texture.extensions.end()) return mapping;
  const tinygltf::Value& extension = found->second;
  mapping.texcoord_set =
      static_cast<int>(std::clamp(numberOr(extension, "texCoord", texture.texCoord), 0.0, 1000.0));
  std::vector<double> offset = numbersOf(extension, "offset", 2);
  std::vector<double> scale = numbersOf(extension, "scale", 2);
  if (offset.empty()) offset = {0.0, 0.0};
  if (scale.empty()) scale = {1.0, 1.0};
  const double rotation = numberOr(extension, "rotation", 0.0);
  const double c = std::cos(rotation);
  const double s = std::sin(rotation);
  mapping.transform = {static_cast<float>(c * scale[0]), static_cast<float>(s * scale[1]),
                       static_cast<float>(offset[0]),    static_cast<float>(-s * scale[0]),
                       static_cast<float>(c * scale[1]), static_cast<float>(offset[1])};
  return mapping;
}

void readAlpha(const tinygltf::Material& source, Material& material, WarningLog& warnings) {
  if (source.alphaMode == "MASK") {
    material.alpha_mode = AlphaMode::kMask;
  } else if (source.alphaMode == "BLEND") {
    material.alpha_mode = AlphaMode::kBlend;
  } else if (source.alphaMode != "OPAQUE" && !source.alphaMode.empty()) {
    warnings.add("unknown alpha mode, drawn opaque", quoted(source));
  }
  if (std::isfinite(source.alphaCutoff)) {
    material.alpha_cutoff = static_cast<float>(std::max(source.alphaCutoff, 0.0));
  }
}

/// The base colour picture and its sampler.
void readTexture(const GltfModel& gltf, const tinygltf::Material& source, const ImageTable& images,
                 Material& material, WarningLog& warnings) {
  const tinygltf::Texture* found = textureOf(gltf, source);
  if (found == nullptr) return;
  const tinygltf::Texture& texture = *found;
  if (texture.source < 0) {
    warnings.add("picture neither PNG nor JPEG, left out", quoted(source));
    return;
  }
  material.image = images.indexOf(texture.source);
  if (texture.sampler < 0) return;
  if (static_cast<std::size_t>(texture.sampler) >= gltf->samplers.size()) {
    gltf.fail(fmt::format("is no valid glTF: there is no sampler {}", texture.sampler));
  }
  const tinygltf::Sampler& sampler = gltf->samplers[static_cast<std::size_t>(texture.sampler)];
  material.wrap_s = wrapOf(sampler.wrapS);
  material.wrap_t = wrapOf(sampler.wrapT);
  material.nearest_filter = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
}

}  // namespace

std::vector<TextureMapping> readMaterials(const GltfModel& gltf, Building& building,
                                          WarningLog& warnings) {
  const ImageTable images(gltf, building, warnings);
  std::vector<TextureMapping> mappings;
  for (const tinygltf::Material& source : gltf->materials) {
    Material material;
    material.name = source.name;
    const BaseColor color = baseColorOf(source);
    material.base_color = colorOf(color.factor);
    material.double_sided = source.doubleSided;
    material.unlit = source.extensions.contains("KHR_materials_unlit");
    readAlpha(source, material, warnings);
    readTexture(gltf, source, images, material, warnings);
    building.materials.push_back(material);
    mappings.push_back(material.image == kNone ? TextureMapping{} : mappingOf(color.texture));
  }
  return mappings;
}

}  // namespace enfilade
