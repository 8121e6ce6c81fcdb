#include "ibr/portal_side.h"

#include <algorithm>

#include "ibr/portal_capture.h"

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

double farDepth(const Building& building, const ImageParameters& parameters) {
  // The far corner of the building's box from a viewpoint on the semicircle.
  return 1.05 * static_cast<double>(glm::length(worldBounds(building).size())) +
         2.0 * static_cast<double>(parameters.switch_distance);
}

}  // namespace enfilade
