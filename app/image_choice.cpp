#include "app/image_choice.h"

#include <algorithm>

#include "portals/polygon.h"

namespace enfilade {

bool isBeyondSwitch(const House& house, const glm::vec3& eye, PortalId id, bool from_front) {
  const Portal& portal = house.graph.portals[id];
  const float ahead = portal.plane.signedDistance(eye);
  return (from_front ? ahead > 0 : ahead < 0) &&
         distanceToPolygon(portal.polygon, portal.plane, eye) > house.switch_distance;
}

namespace {

void chooseReferences(int most, const SideImages& images, const glm::dvec3& eye,
                      ChosenImages& chosen) {
  const ViewpointFan& fan = images.reference_fan;
  const std::size_t first = fan.nearest(eye, [&](std::size_t i) { return images.hasReference(i); });
  if (first == ViewpointFan::kNone) return;
  const std::size_t second = most < 2 ? ViewpointFan::kNone : fan.nearest(eye, [&](std::size_t i) {
    return i != first && images.hasReference(i);
  });
  for (const std::size_t i : {second, first}) {
    if (i != ViewpointFan::kNone) chosen.warped[chosen.warped_count++] = &images.references[i];
  }
}

}  // namespace

ChosenImages chooseImages(const MethodInfo& method, const SideImages& images,
                          const glm::dvec3& eye) {
  ChosenImages chosen;
  switch (method.image_kind) {
    case ImageKind::kTexture:
      chosen.texture_index =
          images.texture_fan.nearest(eye, [&](std::size_t i) { return images.hasTexture(i); });
      if (chosen.texture_index != ViewpointFan::kNone) {
        chosen.texture = &images.textures[chosen.texture_index];
      }
      break;
    case ImageKind::kReference:
      chooseReferences(method.images_at_once, images, eye, chosen);
      break;
    case ImageKind::kLdi:
      if (images.has(ImageKind::kLdi)) chosen.warped[chosen.warped_count++] = &images.ldi;
      break;
  }
  return chosen;
}

std::size_t missingViewpoint(const MethodInfo& method, const SideImages& images,
                             const glm::dvec3& eye) {
  const bool textures = method.image_kind == ImageKind::kTexture;
  const ViewpointFan& fan = textures ? images.texture_fan : images.reference_fan;
  const auto is_there = [&](std::size_t i) {
    return textures ? images.hasTexture(i) : images.hasReference(i);
  };
  std::size_t before = ViewpointFan::kNone;
  for (int rank = 0; rank < method.images_at_once; ++rank) {
    const std::size_t wanted = fan.nearest(eye, [&](std::size_t i) { return i != before; });
    if (wanted == ViewpointFan::kNone || !is_there(wanted)) return wanted;
    before = wanted;
  }
  return ViewpointFan::kNone;
}

}  // namespace enfilade
