#include "app/portal_pictures.h"

#include <tbb/parallel_for.h>

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
/// an earlier frame's picture stands in the buffer.
void clear(Image& picture, const glm::ivec4& box) {
  if (box.x >= box.z) return;
  const auto columns = static_cast<std::size_t>(box.z - box.x);
  for (int y = box.y; y < box.w; ++y) {
    const std::size_t first =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
        static_cast<std::size_t>(box.x);
    std::fill_n(&picture.rgba[4 * first], 4 * columns, std::uint8_t{0});
  }
}

}  // namespace

ScreenPolygon screenPolygonOf(const Portal& portal) {
  return {grownPolygon(portal.polygon, portal.plane, kPortalMargin)};
}

PortalPictures::PortalPictures(const House& house, const PortalImages& images, int width,
                               int height)
    : house_(house), images_(images), width_(width), height_(height) {}

bool PortalPictures::showsImage(const glm::vec3& eye, PortalId id, bool from_front) const {
  if (!images_.find(id, from_front)) return false;
  const Portal& portal = house_.graph.portals[id];
  const float ahead = portal.plane.signedDistance(eye);
  return (from_front ? ahead > 0 : ahead < 0) &&
         distanceToPolygon(portal.polygon, portal.plane, eye) > house_.switch_distance;
}

void PortalPictures::warp(const PlanarCamera& desired, Picture& picture) const {
  Image& color = picture.buffer.color;
  if (color.rgba.empty()) picture.buffer.resize(width_, height_);
  const Ldi& ldi = *images_.find(picture.portal->portal, picture.portal->from_front);
  std::vector<std::vector<glm::vec2>> regions;
  picture.box = {width_, height_, 0, 0};
  for (const ScreenRegion& region : picture.portal->regions) {
    regions.push_back(toPixels(region.corners, color));
    picture.box = grownBy(picture.box, regions.back(), color);
  }
  clear(color, picture.box);
  picture.counts = {};
  for (const auto& region : regions) {
    const WarpCounts counts = warpLdi(ldi, desired, region, picture.buffer);
    picture.counts.samples += counts.samples;
    picture.counts.samples_clipped += counts.samples_clipped;
    picture.counts.pixels_uncovered += counts.pixels_uncovered;
  }
}

void PortalPictures::draw(const VisibleSet& set, const Camera& camera, Renderer& renderer,
                          FrameCost& cost) {
  Stopwatch watch;
  used_ = 0;
  for (const VisiblePortal& visible : set.portals) {
    if (!visible.as_image) continue;
    if (used_ == pictures_.size()) pictures_.emplace_back();
    pictures_[used_++].portal = &visible;
  }
  const PlanarCamera desired = planarCamera(camera, width_, height_);
  tbb::parallel_for(std::size_t{0}, used_, [&](std::size_t i) { warp(desired, pictures_[i]); });
  cost.warp_ms = watch.lapMs();
  for (std::size_t i = 0; i < used_; ++i) {
    const ScreenPolygon polygon =
        screenPolygonOf(house_.graph.portals[pictures_[i].portal->portal]);
    renderer.drawScreenPolygons({&polygon, 1}, pictures_[i].buffer.color, pictures_[i].box,
                                camera.clipFromWorld());
  }
  cost.composite_ms = watch.lapMs();
  addCounts(cost);
}

void PortalPictures::addCounts(FrameCost& cost) const {
  WarpCounts sum;
  for (std::size_t i = 0; i < used_; ++i) {
    sum.samples += pictures_[i].counts.samples;
    sum.samples_clipped += pictures_[i].counts.samples_clipped;
    sum.pixels_uncovered += pictures_[i].counts.pixels_uncovered;
  }
  cost.portals_as_images = used_;
  cost.samples = sum.samples;
  cost.samples_clipped = sum.samples_clipped;
  cost.uncovered_percent =
      100.0 * static_cast<double>(sum.pixels_uncovered) / (static_cast<double>(width_) * height_);
}

}  // namespace enfilade
