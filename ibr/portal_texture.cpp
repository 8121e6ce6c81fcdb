// Aliaga & Lastra, Architectural Walkthroughs using Portal Textures, 1997.
#include "ibr/portal_texture.h"

#include "ibr/portal_frame.h"

namespace enfilade {

Image captureTexture(const Portal& portal, bool from_front, const glm::dvec3& viewpoint,
                     const ImageParameters& parameters, const CaptureFunction& capture) {
  return capture(portalCamera(portal, from_front, viewpoint, parameters)).color;
}

std::vector<glm::vec2> textureCoordinates(const Portal& portal, bool from_front, float margin,
                                          std::span<const glm::vec3> polygon) {
  const PortalFrame frame = portalFrame(portal, from_front);
  const glm::dvec2 half(frame.half_width + static_cast<double>(margin),
                        frame.half_height + static_cast<double>(margin));
  std::vector<glm::vec2> coordinates;
  coordinates.reserve(polygon.size());
  for (const glm::vec3& corner : polygon) {
    const glm::dvec3 offset = glm::dvec3(corner) - frame.center;
    coordinates.emplace_back(0.5 + 0.5 * glm::dot(offset, frame.right) / half.x,
                             0.5 - 0.5 * glm::dot(offset, frame.up) / half.y);
  }
  return coordinates;
}

}  // namespace enfilade
