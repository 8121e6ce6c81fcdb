#include "ibr/portal_window.h"

#include "ibr/convex_region.h"

namespace enfilade {

std::vector<glm::ivec2> pixelsThrough(std::span<const glm::vec3> polygon,
                                      const PlanarCamera& camera) {
  std::vector<glm::vec2> outline;
  for (const glm::vec3& corner : polygon) {
    outline.emplace_back(projectPoint(camera, glm::dvec3(corner)));
  }
  std::vector<glm::ivec2> spans(static_cast<std::size_t>(camera.height), glm::ivec2(0));
  fillConvexPolygon(outline, camera.width, camera.height, spans);
  return spans;
}

}  // namespace enfilade
