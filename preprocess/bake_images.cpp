#include "preprocess/bake_images.h"

#include <fmt/format.h>

#include <filesystem>

#include "ibr/ldi_file.h"
#include "ibr/portal_capture.h"
#include "ibr/portal_side.h"
#include "preprocess/bake_views.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene/file_io.h"
#include "visibility/object_index.h"
#include "visibility/portal_culling.h"

namespace enfilade {

BakedImages bakeImages(const House& house, const ImageParameters& parameters,
                       const std::string& folder, int threads, const ProgressSink& progress) {
  const auto context = createOsMesaContext(threads);
  Renderer renderer(*context, house.building);
  const ObjectIndex index(house);
  const double far_depth = farDepth(house.building, parameters);
  BakedImages baked;
  for (PortalId id = 0; id < house.graph.portals.size(); ++id) {
    const Portal& portal = house.graph.portals[id];
    for (const bool from_front : {true, false}) {
      if (!getsImage(portal, from_front)) continue;
      const auto objects = [&](const View& view) {
        return index.visible(cullBehindPortal(house.graph, view, id, from_front));
      };
      const float eye_y = eyeLevelBefore(house.graph, portal, from_front, house.eye_height);
      const std::string images = portalImageFolder(folder, id, from_front);
      createFolders(images);
      if (parameters.bake.ldis) {
        const Ldi ldi =
            bakeLdi(renderer, portal, from_front, eye_y, parameters, objects, far_depth);
        const std::string file = images + "/ldi.bin";
        writeLdi(file, ldi);
        baked.bytes += std::filesystem::file_size(file);
      }
      const auto capture = [&](const PlanarCamera& camera) {
        return captureThroughPortal(renderer, camera, objects, far_depth);
      };
      baked.bytes += bakeViews(portal, from_front, eye_y, parameters, capture, images);
      ++baked.images;
    }
    if (progress) {
      progress("bake the portals' images",
               static_cast<double>(id + 1) / static_cast<double>(house.graph.portals.size()));
    }
  }
  return baked;
}

}  // namespace enfilade
