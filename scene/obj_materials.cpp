#include "scene/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/color_space.hpp>
#include <map>

#include "scene/error.h"
#include "scene/file_io.h"
#include "scene/picture_budget.h"
#include "scene/short_name.h"

namespace enfilade {
namespace {

/// The pictures read so far, by name.
class Pictures {
 public:
  Pictures(const ObjResources& resources, Building& building, WarningLog& warnings)
      : resources_(resources), building_(building), warnings_(warnings) {}

  /// Its index in Building::images; kNone if there is none such.
  std::uint32_t find(const std::string& name) {
    if (name.empty()) return kNone;
    const auto [known, is_new] = known_.try_emplace(name, kNone);
    if (is_new) known->second = read(name);
    return known->second;
  }

 private:
  std::uint32_t read(const std::string& name) {
    auto bytes = resources_(name);
    if (!bytes) {
      warnings_.add("picture left out, it cannot be read from the model's folder",
                    "\"" + oneLine(name) + "\"");
      return kNone;
    }
    // The same file may have many names.
    const auto [same, is_new] = by_content_.try_emplace(sha256Hex(*bytes), kNone);
    if (!is_new) return same->second;
    bytes_ += bytes->size();
    TextureImage picture;
    picture.name = name;
    try {
      if (!fits_) throw Error(ErrorKind::kBadInput, name, kTooMany);
      picture.image = decodeImage(*bytes, name);
      fits_ = budget_.add(picture.image.rgba.size() / 4, bytes_);
      if (!fits_) throw Error(ErrorKind::kBadInput, name, kTooMany);
    } catch (const Error& error) {
      warnings_.add("picture left out", oneLine(error.what(), 200));
      return kNone;
    }
    picture.mime_type = imageMimeType(*bytes);
    picture.encoded = std::move(*bytes);
    building_.images.push_back(std::move(picture));
    same->second = static_cast<std::uint32_t>(building_.images.size() - 1);
    return same->second;
  }

  static constexpr const char* kTooMany =
      "the pictures up to it are of far more pixels than their bytes can hold";

  const ObjResources& resources_;
  Building& building_;
  WarningLog& warnings_;
  PictureBudget budget_;
  std::size_t bytes_ = 0;  // of the pictures' files
  bool fits_ = true;
  std::map<std::string, std::uint32_t> known_, by_content_;
};

Material materialOf(const tinyobj::material_t& source, Pictures& pictures) {
  Material material;
  material.name = source.name;
  shortenName(material.name);
  material.double_sided = true;
  material.image = pictures.find(source.diffuse_texname);
  glm::vec3 color(0);
  for (int c = 0; c < 3; ++c) {
    if (source.diffuse[c] > 0) color[c] = std::min(float(source.diffuse[c]), 1.0f);
  }
  color = glm::convertSRGBToLinear(color);
  // Exporters often leave Kd black where a picture says it all.
  if (material.image != kNone && color == glm::vec3(0)) color = glm::vec3(1);
  const float alpha =
      std::isfinite(source.dissolve) ? std::clamp(float(source.dissolve), 0.0f, 1.0f) : 1.0f;
  material.base_color = glm::vec4(color, alpha);
  if (alpha < 1) {
    material.alpha_mode = AlphaMode::kBlend;
  } else if (!source.alpha_texname.empty() && source.alpha_texname == source.diffuse_texname) {
    material.alpha_mode = AlphaMode::kMask;  // leaves cut out of a picture
  }
  if (source.diffuse_texopt.clamp) material.wrap_s = material.wrap_t = Wrap::kClampToEdge;
  return material;
}

}  // namespace

void addObjMaterials(const std::vector<tinyobj::material_t>& materials,
                     const ObjResources& resources, Building& building, WarningLog& warnings) {
  Pictures pictures(resources, building, warnings);
  for (const tinyobj::material_t& source : materials) {
    building.materials.push_back(materialOf(source, pictures));
  }
  Material plain;
  plain.name = "none";
  plain.base_color = glm::vec4(glm::convertSRGBToLinear(glm::vec3(0.8f)), 1.0f);
  plain.double_sided = true;
  building.materials.push_back(plain);
}

}  // namespace enfilade
