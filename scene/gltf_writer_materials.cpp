#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "scene/gltf_writer_parts.h"

namespace enfilade {
namespace {

using nlohmann::ordered_json;

void writeImages(const Building& building, ordered_json& root, GlbBuffer& buffer) {
  for (const TextureImage& image : building.images) {
    const bool encoded = !image.encoded.empty();
    const std::size_t start = buffer.size();
    std::size_t size = image.encoded.size();
    if (encoded) {
      buffer.add(image.encoded);
    } else {
      std::vector<std::uint8_t> png = encodePng(image.image);
      size = png.size();
      buffer.addOwned(std::move(png));
    }
    ordered_json json;
    if (!image.name.empty()) json["name"] = image.name;
    json["mimeType"] = encoded ? image.mime_type : "image/png";
    json["bufferView"] = addBufferView(root, start, size, 0, 0);
    root["images"].push_back(std::move(json));
  }
}

int numberOf(Wrap wrap) {
  if (wrap == Wrap::kClampToEdge) return 33071;
  return wrap == Wrap::kMirroredRepeat ? 33648 : 10497;
}

/// Textures: pairs of an image and a sampler, each written once.
class TextureTable {
 public:
  explicit TextureTable(ordered_json& root) : root_(root) {}

  int textureOf(const Material& material) {
    const int sampler = samplerOf(material);
    const auto [entry, is_new] = textures_.try_emplace(std::pair(material.image, sampler),
                                                       static_cast<int>(textures_.size()));
    if (is_new) root_["textures"].push_back({{"sampler", sampler}, {"source", material.image}});
    return entry->second;
  }

 private:
  int samplerOf(const Material& material) {
    const auto key = std::tuple(material.wrap_s, material.wrap_t, material.nearest_filter);
    const auto [entry, is_new] = samplers_.try_emplace(key, static_cast<int>(samplers_.size()));
    if (is_new) {
      root_["samplers"].push_back({{"magFilter", material.nearest_filter ? 9728 : 9729},
                                   {"minFilter", material.nearest_filter ? 9986 : 9987},
                                   {"wrapS", numberOf(material.wrap_s)},
                                   {"wrapT", numberOf(material.wrap_t)}});
    }
    return entry->second;
  }

  ordered_json& root_;
  std::map<std::tuple<Wrap, Wrap, bool>, int> samplers_;
  std::map<std::pair<std::uint32_t, int>, int> textures_;
};

ordered_json encodeMaterial(const Material& material, TextureTable& textures) {
  ordered_json json;
  if (!material.name.empty()) json["name"] = material.name;
  const glm::vec4& c = material.base_color;
  // Other programs shall show it as dull as we do.
  ordered_json pbr{{"baseColorFactor", {c.r, c.g, c.b, c.a}}, {"metallicFactor", 0}};
  if (material.image != kNone) pbr["baseColorTexture"] = {{"index", textures.textureOf(material)}};
  json["pbrMetallicRoughness"] = std::move(pbr);
  if (material.alpha_mode == AlphaMode::kMask) {
    json["alphaMode"] = "MASK";
    json["alphaCutoff"] = material.alpha_cutoff;
  } else if (material.alpha_mode == AlphaMode::kBlend) {
    json["alphaMode"] = "BLEND";
  }
  if (material.double_sided) json["doubleSided"] = true;
  if (material.unlit) json["extensions"]["KHR_materials_unlit"] = ordered_json::object();
  return json;
}

}  // namespace

void writeMaterials(const Building& building, ordered_json& root, GlbBuffer& buffer) {
  writeImages(building, root, buffer);
  TextureTable textures(root);
  bool any_unlit = false;
  for (const Material& material : building.materials) {
    root["materials"].push_back(encodeMaterial(material, textures));
    any_unlit = any_unlit || material.unlit;
  }
  if (any_unlit) root["extensionsUsed"].push_back("KHR_materials_unlit");
}

}  // namespace enfilade
