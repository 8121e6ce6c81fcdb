#include "preprocess/bake_views.h"

#include <filesystem>

#include "ibr/ldi_file.h"
#include "ibr/portal_texture.h"
#include "ibr/reference_image.h"
#include "ibr/viewpoint_fan.h"

namespace enfilade {

std::uint64_t bakeViews(const Portal& portal, bool from_front, float eye_y,
                        const ImageParameters& parameters, const CaptureFunction& capture,
                        const std::string& folder) {
  std::uint64_t bytes = 0;
  const auto forEachViewpoint = [&](int count, auto&& write) {
    const ViewpointFan fan(portal, from_front, eye_y, parameters, count);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      bytes += std::filesystem::file_size(write(i, fan.viewpoints()[i]));
    }
  };
  if (parameters.bake.textures) {
    forEachViewpoint(parameters.textures, [&](std::size_t i, const glm::dvec3& at) {
      const std::string file = folder + "/" + textureFileName(i);
      writePng(file, captureTexture(portal, from_front, at, parameters, capture));
      return file;
    });
  }
  if (parameters.bake.references) {
    forEachViewpoint(parameters.references, [&](std::size_t i, const glm::dvec3& at) {
      const std::string file = folder + "/" + referenceFileName(i);
      writeLdi(file, captureReference(portal, from_front, at, parameters, capture));
      return file;
    });
  }
  return bytes;
}

}  // namespace enfilade
