#include "preprocess/bake_views.h"

#include "ibr/ldi_file.h"
#include "ibr/portal_texture.h"
#include "ibr/reference_image.h"
#include "ibr/viewpoint_fan.h"

namespace enfilade {

void bakeViews(const Portal& portal, bool from_front, float eye_y,
               const ImageParameters& parameters, const CaptureFunction& capture,
               const std::string& folder) {
  const auto forEachViewpoint = [&](int count, auto&& write) {
    const ViewpointFan fan(portal, from_front, eye_y, parameters, count);
    for (std::size_t i = 0; i < fan.size(); ++i) write(i, fan.viewpoints()[i]);
  };
  if (parameters.bake.textures) {
    forEachViewpoint(parameters.textures, [&](std::size_t i, const glm::dvec3& at) {
      writePng(folder + "/" + textureFileName(i),
               captureTexture(portal, from_front, at, parameters, capture));
    });
  }
  if (parameters.bake.references) {
    forEachViewpoint(parameters.references, [&](std::size_t i, const glm::dvec3& at) {
      writeLdi(folder + "/" + referenceFileName(i),
               captureReference(portal, from_front, at, parameters, capture));
    });
  }
}

}  // namespace enfilade
