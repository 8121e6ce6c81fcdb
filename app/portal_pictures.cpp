#include "app/portal_pictures.h"

#include <algorithm>
#include <cmath>

#include "app/stopwatch.h"
#include "portals/polygon.h"

namespace enfilade {

namespace {

/// NDC to pixels, row 0 on top.
std::vector<glm::vec2> toPixels(const std::vector<glm::vec2>& corners, const Image& frame) {
  std::vector<glm::vec2> pixels;
  pixels.reserve(corners.size());
  for (const glm::vec2& c : corners) {
    pixels.emplace_back(0.5f * (1.0f + c.x) * static_cast<float>(frame.width),
                        0.5f * (1.0f - c.y) * static_cast<float>(frame.height));
  }
  return pixels;
}

/// x0, y0, x1, y1 of the pixels that `polygon` touches, grown to hold those of `box`.
glm::ivec4 grownBy(const glm::ivec4& box, const std::vector<glm::vec2>& polygon,
                   const Image& frame) {
  glm::ivec4 grown = box;
  for (const glm::vec2& p : polygon) {
    grown.x = std::min(grown.x, static_cast<int>(std::floor(p.x)));
    grown.y = std::min(grown.y, static_cast<int>(std::floor(p.y)));
    grown.z = std::max(grown.z, static_cast<int>(std::ceil(p.x)));
    grown.w = std::max(grown.w, static_cast<int>(std::ceil(p.y)));
  }
  return {std::max(grown.x, 0), std::max(grown.y, 0), std::min(grown.z, frame.width),
          std::min(grown.w, frame.height)};
}

/// Nothing fell into the pixels of `box`.  The portal's polygon may reach beyond its regions, where
/// another portal's picture may stand in the buffer.
void clear(Image& picture, const glm::ivec4& box) {
  if (box.x >= box.z) return;
  for (int y = box.y; y < box.w; ++y) {
    const std::ptrdiff_t row = 4 * static_cast<std::ptrdiff_t>(y) * picture.width;
    std::fill(picture.rgba.begin() + row + 4 * box.x, picture.rgba.begin() + row + 4 * box.z,
              std::uint8_t{0});
  }
}

}  // namespace

PortalPictures::PortalPictures(const House& house, const PortalImages& images, int width,
                               int height)
    : house_(house), images_(images) {
  buffer_.resize(width, height);
}

bool PortalPictures::showsImage(const glm::vec3& eye, PortalId id, bool from_front) const {
  if (!images_.find(id, from_front)) return false;
  const Portal& portal = house_.graph.portals[id];
  const float ahead = portal.plane.signedDistance(eye);
  return (from_front ? ahead > 0 : ahead < 0) &&
         distanceToPolygon(portal.polygon, portal.plane, eye) > house_.switch_distance;
}

void PortalPictures::draw(const VisibleSet& set, const Camera& camera, Renderer& renderer,
                          FrameCost& cost) {
  Image& picture = buffer_.color;
  const PlanarCamera desired = planarCamera(camera, picture.width, picture.height);
  const glm::mat4 clip_from_world = camera.clipFromWorld();
  WarpCounts sum;
  std::size_t images = 0;
  double warp_ms = 0, composite_ms = 0;
  // One portal after the other, as the regions of two may overlap on screen: depth decides.
  for (const VisiblePortal& visible : set.portals) {
    if (!visible.as_image) continue;
    ++images;
    Stopwatch watch;
    const Ldi& ldi = *images_.find(visible.portal, visible.from_front);
    std::vector<std::vector<glm::vec2>> regions;
    glm::ivec4 box(picture.width, picture.height, 0, 0);
    for (const ScreenRegion& region : visible.regions) {
      regions.push_back(toPixels(region.corners, picture));
      box = grownBy(box, regions.back(), picture);
    }
    clear(picture, box);
    for (const auto& region : regions) {
      const WarpCounts counts = warpLdi(ldi, desired, region, buffer_);
      sum.samples += counts.samples;
      sum.samples_clipped += counts.samples_clipped;
      sum.pixels_uncovered += counts.pixels_uncovered;
    }
    warp_ms += watch.lapMs();
    // As large as it is taken for in culling; the solid jambs stand before what is too much.
    const Portal& portal = house_.graph.portals[visible.portal];
    const ScreenPolygon polygon{grownPolygon(portal.polygon, portal.plane, kPortalMargin)};
    renderer.drawScreenPolygons({&polygon, 1}, picture, box, clip_from_world);
    composite_ms += watch.lapMs();
  }
  cost.warp_ms = warp_ms;
  cost.composite_ms = composite_ms;
  cost.portals_as_images = images;
  cost.samples = sum.samples;
  cost.samples_clipped = sum.samples_clipped;
  cost.uncovered_percent = 100.0 * static_cast<double>(sum.pixels_uncovered) /
                           (static_cast<double>(picture.width) * picture.height);
}

}  // namespace enfilade
