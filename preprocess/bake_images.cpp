#include "preprocess/bake_images.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "ibr/ldi_file.h"
#include "ibr/portal_capture.h"
#include "render/gl_context.h"
#include "render/renderer.h"
#include "scene/file_io.h"
#include "visibility/object_index.h"
#include "visibility/portal_culling.h"

namespace enfilade {

float eyeLevelBefore(const CellGraph& graph, const Portal& portal, bool from_front,
                     float eye_height) {
  float low = portal.polygon[0].y;
  float high = low;
  for (const glm::vec3& corner : portal.polygon) {
    low = std::min(low, corner.y);
    high = std::max(high, corner.y);
  }
  const Cell& cell = graph.cells[from_front ? portal.front : portal.back];
  float floor = graph.storeys[static_cast<std::size_t>(cell.storey)].floor_y;
  if (portal.kind != PortalKind::kWindow) floor = low;  // one stands in a doorway's own floor
  return std::clamp(floor + eye_height, low, high);
}

bool getsImage(const Portal& portal, bool from_front) {
  return portal.active && (portal.two_way || from_front) && canShowImages(portal);
}

namespace {

// Farther than any corner of the building is from any viewpoint before a portal.
double farDepth(const House& house, const ImageParameters& parameters) {
  return 1.05 * static_cast<double>(glm::length(worldBounds(house.building).size())) +
         2.0 * static_cast<double>(parameters.switch_distance);
}

}  // namespace

BakedImages bakeImages(const House& house, const ImageParameters& parameters,
                       const std::string& folder, int threads, const ProgressSink& progress) {
  const auto context = createOsMesaContext(threads);
  Renderer renderer(*context, house.building);
  const ObjectIndex index(house);
  const double far_depth = farDepth(house, parameters);
  BakedImages baked;
  for (PortalId id = 0; id < house.graph.portals.size(); ++id) {
    const Portal& portal = house.graph.portals[id];
    for (const bool from_front : {true, false}) {
      if (!getsImage(portal, from_front)) continue;
      const auto objects = [&](const View& view) {
        return index.visible(cullBehindPortal(house.graph, view, id, from_front));
      };
      const float eye_y = eyeLevelBefore(house.graph, portal, from_front, house.eye_height);
      const Ldi ldi = bakeLdi(renderer, portal, from_front, eye_y, parameters, objects, far_depth);
      const std::string images = portalImageFolder(folder, id, from_front);
      createFolders(images);
      const std::string file = images + "/ldi.bin";
      writeLdi(file, ldi);
      ++baked.images;
      baked.bytes += std::filesystem::file_size(file);
    }
    if (progress) {
      progress("bake the portals' images",
               static_cast<double>(id + 1) / static_cast<double>(house.graph.portals.size()));
    }
  }
  return baked;
}

}  // namespace enfilade
