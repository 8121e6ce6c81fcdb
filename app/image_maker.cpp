#include "app/image_maker.h"

#include <algorithm>
#include <cmath>

#include "ibr/portal_side.h"
#include "ibr/portal_texture.h"
#include "ibr/reference_image.h"

namespace enfilade {

namespace {

/// Bytes that an unfinished layered depth image takes for each sample captured, about.
constexpr std::size_t kBytesInTheMaking = 56;

/// A layered depth image of the central capture alone leaves three times as much uncovered as one
/// of three; with more the portal would be drawn as geometry for longer.
constexpr std::size_t kCapturesToShow = 3;

/// Of a portal's regions on screen, in NDC.
double areaOnScreen(const VisiblePortal& visible) {
  double area = 0;
  for (const ScreenRegion& region : visible.regions) {
    for (std::size_t i = 0; i < region.corners.size(); ++i) {
      const glm::dvec2 a(region.corners[i]);
      const glm::dvec2 b(region.corners[(i + 1) % region.corners.size()]);
      area += 0.5 * (a.x * b.y - a.y * b.x);
    }
  }
  return std::abs(area);
}

}  // namespace

bool ImageMaker::Need::before(const Need& other) const noexcept {
  if (other.portal == nullptr) return true;
  if (has_none != other.has_none) return has_none;
  return area > other.area;
}

ImageMaker::ImageMaker(const MethodInfo& method, const House& house, const ObjectIndex& objects,
                       Renderer& renderer, std::size_t most_bytes)
    : method_(method),
      house_(house),
      objects_(objects),
      renderer_(renderer),
      parameters_(imageParametersFrom(house.info.parameters, "house.json")),
      far_depth_(farDepth(house.building, parameters_)),
      most_bytes_(most_bytes) {
  forget();
}

void ImageMaker::forget() {
  images_ = PortalImages(house_);
  sides_.clear();
  sides_.resize(2 * house_.graph.portals.size());
  kept_ = Recency(sides_.size());
}

ImageMaker::Side& ImageMaker::sideOf(const VisiblePortal& visible) {
  return sides_[sideIndex(visible.portal, visible.from_front)];
}

bool ImageMaker::lacks(const VisiblePortal& visible, const glm::vec3& eye) {
  if (!getsImage(house_.graph.portals[visible.portal], visible.from_front)) return false;
  if (method_.image_kind == ImageKind::kLdi) return !sideOf(visible).complete;
  const SideImages& images = images_.side(visible.portal, visible.from_front);
  return missingViewpoint(method_, images, glm::dvec3(eye)) != ViewpointFan::kNone;
}

bool ImageMaker::makeOne(const VisibleSet& set, const glm::vec3& eye) {
  kept_.beginRound();
  Need first;
  for (const VisiblePortal& visible : set.portals) {
    if (!isBeyondSwitch(house_, eye, visible.portal, visible.from_front)) continue;
    kept_.use(sideIndex(visible.portal, visible.from_front));
    if (!lacks(visible, eye)) continue;
    const SideImages& images = images_.side(visible.portal, visible.from_front);
    const Need need{&visible, !images.has(method_.image_kind), areaOnScreen(visible)};
    if (need.before(first)) first = need;
  }
  if (first.portal == nullptr) return false;
  make(*first.portal, eye);
  evict();
  return true;
}

void ImageMaker::make(const VisiblePortal& visible, const glm::vec3& eye) {
  const Portal& portal = house_.graph.portals[visible.portal];
  const bool from_front = visible.from_front;
  const CaptureFunction capture = [&](const PlanarCamera& camera) {
    const auto objects = [&](const View& view) {
      return objects_.visible(cullBehindPortal(house_.graph, view, visible.portal, from_front));
    };
    const int rays = method_.image_kind == ImageKind::kLdi ? parameters_.rays : 1;
    return captureThroughPortal(renderer_, camera, objects, far_depth_, rays);
  };
  SideImages& images = images_.side(visible.portal, from_front);
  Side& side = sideOf(visible);
  const std::size_t i = missingViewpoint(method_, images, glm::dvec3(eye));
  switch (method_.image_kind) {
    case ImageKind::kTexture:
      images.textures[i] = captureTexture(portal, from_front, images.texture_fan.viewpoints()[i],
                                          parameters_, capture);
      break;
    case ImageKind::kReference:
      images.references[i] = captureReference(
          portal, from_front, images.reference_fan.viewpoints()[i], parameters_, capture);
      break;
    case ImageKind::kLdi:
      makeLdi(side, images, visible, capture);
      break;
  }
  const std::size_t making = side.making ? kBytesInTheMaking * side.making->samplesCaptured() : 0;
  kept_.keep(sideIndex(visible.portal, from_front), images.bytes() + making);
}

void ImageMaker::makeLdi(Side& side, SideImages& images, const VisiblePortal& visible,
                         const CaptureFunction& capture) {
  if (!side.making) {
    const Portal& portal = house_.graph.portals[visible.portal];
    const float eye_y = eyeLevelBefore(house_.graph, portal, visible.from_front, house_.eye_height);
    side.making = std::make_unique<PortalLdi>(portal, visible.from_front, eye_y, parameters_);
  }
  if (!side.making->complete()) side.making->captureNext(capture);
  side.complete = side.making->complete();
  const bool few = side.making->captured() < kCapturesToShow;
  if (!few || side.complete) images.ldi = side.making->finish();
  if (!side.complete) return;
  side.making.reset();
  side.complete = true;
}

void ImageMaker::evict() {
  while (kept_.bytes() > most_bytes_) {
    const std::size_t index = kept_.leastRecent();
    if (index == Recency::kNone) return;
    SideImages& images = images_.side(static_cast<PortalId>(index / 2), index % 2 == 0);
    images.textures.assign(images.textures.size(), Image());
    images.references.assign(images.references.size(), Ldi());
    images.ldi = Ldi();
    sides_[index] = Side();
    kept_.keep(index, 0);
  }
}

}  // namespace enfilade
