#include "app/portal_pictures.h"

#include <algorithm>
#include <cmath>

#include "app/stopwatch.h"
#include "ibr/convex_region.h"
#include "ibr/portal_texture.h"
#include "ibr/warp_scratch.h"
#include "portals/polygon.h"

namespace enfilade {

namespace {

constexpr std::uint64_t kMostViewpoints =
    256;  // of a side, so that textures have keys of their own

/// NDC to pixels, row 0 on top.
void toPixels(const std::vector<glm::vec2>& corners, const Image& frame,
              std::vector<glm::vec2>& pixels) {
  pixels.clear();
  for (const glm::vec2& c : corners) {
    pixels.emplace_back(0.5f * (1.0f + c.x) * static_cast<float>(frame.width),
                        0.5f * (1.0f - c.y) * static_cast<float>(frame.height));
  }
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

PortalPictures::PortalPictures(const House& house, int width, int height, int threads)
    : house_(house),
      texture_margin_(imageParametersFrom(house.info.parameters, "house.json").portal_margin),
      width_(width),
      height_(height),
      team_(threads),
      spans_(static_cast<std::size_t>(height)),
      scratch_(std::make_shared<WarpScratch>()) {}

void PortalPictures::resize(int width, int height) {
  width_ = width;
  height_ = height;
  spans_.resize(static_cast<std::size_t>(height));
  pictures_.clear();  // their buffers are of the old size
  used_ = 0;
  before_.clear();
}

void PortalPictures::setWarping(const Warping& warping) {
  warping_ = warping;
  before_.clear();
}

void PortalPictures::begin(Picture& picture) const {
  Image& color = picture.buffer.color;
  if (color.rgba.empty()) picture.buffer.resize(width_, height_);
  picture.box = {width_, height_, 0, 0};
  picture.regions.resize(picture.portal->regions.size());
  for (std::size_t i = 0; i < picture.regions.size(); ++i) {
    toPixels(picture.portal->regions[i].corners, color, picture.regions[i]);
    picture.box = grownBy(picture.box, picture.regions[i], color);
  }
  clear(color, picture.box);
}

/// Warps region `round` of every picture that has as many: regions of one portal may overlap, and
/// are not warped at once.
WarpCounts PortalPictures::warpRound(const PlanarCamera& desired, std::size_t round) {
  jobs_.clear();
  for (std::size_t i = 0; i < used_; ++i) {
    Picture& picture = pictures_[i];
    if (round >= picture.regions.size()) continue;
    const std::span images(picture.chosen.warped.data(), picture.chosen.warped_count);
    jobs_.push_back({images, picture.regions[round], &picture.buffer, {}});
  }
  warpJobs(jobs_, desired, {warping_.splat, warping_.clip, &team_});
  WarpCounts sum;
  for (const WarpJob& job : jobs_) sum += job.counts;
  return sum;
}

void PortalPictures::warpAll(Method method, const Camera& camera, FrameCost& cost) {
  const PlanarCamera desired = planarCamera(camera, width_, height_);
  std::size_t rounds = 0;
  for (std::size_t i = 0; i < used_; ++i) {
    begin(pictures_[i]);
    rounds = std::max(rounds, pictures_[i].regions.size());
  }
  WarpCounts sum;
  for (std::size_t round = 0; round < rounds; ++round) sum += warpRound(desired, round);
  cost.samples = sum.samples;
  cost.samples_clipped = sum.samples_clipped;
  cost.uncovered_percent =
      100.0 * static_cast<double>(sum.pixels_uncovered) / (static_cast<double>(width_) * height_);
  if (warping_.holes != Holes::kNothing) fillHoles(method);
}

void PortalPictures::fillHoles(Method method) {
  const bool persist = warping_.holes == Holes::kPersist;
  Image& before = before_[method];
  if (persist) {
    now_.width = width_;
    now_.height = height_;
    now_.rgba.assign(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0);
    if (before.rgba.empty()) before = now_;
  }
  for (std::size_t i = 0; i < used_; ++i) {
    Image& color = pictures_[i].buffer.color;
    for (const std::vector<glm::vec2>& region : pictures_[i].regions) {
      const RowRange rows = fillConvexPolygon(region, width_, height_, spans_);
      if (persist) {
        HoleFiller::persist(before, spans_, rows.top, rows.bottom, color);
        HoleFiller::persist(color, spans_, rows.top, rows.bottom, now_);
      } else {
        filler_.inpaint(spans_, rows.top, rows.bottom, color);
      }
    }
  }
  if (persist) std::swap(before, now_);
}

bool PortalPictures::isUncovered(const PortalMask& mask, std::size_t pixel) const noexcept {
  constexpr std::size_t kTold = 254;  // what the mask tells apart
  const std::size_t picture = mask.of_pixel[pixel];
  if (picture == 0 || picture > std::min(used_, kTold)) return false;
  const std::vector<std::uint8_t>& rgba = pictures_[picture - 1].buffer.color.rgba;
  return !rgba.empty() && rgba[4 * pixel + 3] != kAlphaOfSample;
}

std::size_t PortalPictures::uncoveredPixels(const PortalMask& mask) const noexcept {
  std::size_t uncovered = 0;
  for (std::size_t p = 0; p < mask.of_pixel.size(); ++p) uncovered += isUncovered(mask, p);
  return uncovered;
}

void PortalPictures::markUncovered(const PortalMask& mask, std::vector<std::uint8_t>& out) const {
  out.resize(mask.of_pixel.size());
  for (std::size_t p = 0; p < out.size(); ++p) out[p] = isUncovered(mask, p);
}

void PortalPictures::drawWarped(const Picture& picture, const Camera& camera,
                                Renderer& renderer) const {
  const ScreenPolygon polygon = screenPolygonOf(house_.graph.portals[picture.portal->portal]);
  renderer.drawScreenPolygons({&polygon, 1}, picture.buffer.color, picture.box,
                              camera.clipFromWorld());
}

void PortalPictures::drawTexture(const Picture& picture, const Camera& camera,
                                 Renderer& renderer) const {
  const auto [id, from_front] = std::pair(picture.portal->portal, picture.portal->from_front);
  const Portal& portal = house_.graph.portals[id];
  const std::vector<glm::vec3> polygon = screenPolygonOf(portal).polygon;
  const std::uint64_t key =
      1 + kMostViewpoints * sideIndex(id, from_front) + picture.chosen.texture_index;
  renderer.drawTexturedPolygon(polygon,
                               textureCoordinates(portal, from_front, texture_margin_, polygon),
                               *picture.chosen.texture, camera.clipFromWorld(), key);
}

void PortalPictures::choose(const MethodInfo& method, const PortalImages& images,
                            const VisibleSet& set, const glm::vec3& eye) {
  used_ = 0;
  for (const VisiblePortal& visible : set.portals) {
    if (!visible.as_image) continue;
    if (used_ == pictures_.size()) pictures_.emplace_back(scratch_);
    Picture& picture = pictures_[used_++];
    picture.portal = &visible;
    picture.chosen =
        chooseImages(method, images.side(visible.portal, visible.from_front), glm::dvec3(eye));
    if (!stand_in_) continue;
    for (std::size_t i = 0; i < picture.chosen.warped_count; ++i) {
      picture.chosen.warped[i] = stand_in_(*picture.chosen.warped[i]);
    }
  }
}

void PortalPictures::draw(const MethodInfo& method, const PortalImages& images,
                          const VisibleSet& set, const glm::vec3& chosen_for, const Camera& camera,
                          Renderer& renderer, FrameCost& cost) {
  Stopwatch watch;
  choose(method, images, set, chosen_for);
  cost.portals_as_images = used_;
  const bool mapped = method.image_kind == ImageKind::kTexture;
  if (mapped) {
    cost.uncovered_percent = 0;  // a texture has no holes
  } else {
    warpAll(method.method, camera, cost);
    cost.warp_ms = watch.lapMs();
  }
  for (std::size_t i = 0; i < used_; ++i) {
    (this->*(mapped ? &PortalPictures::drawTexture : &PortalPictures::drawWarped))(
        pictures_[i], camera, renderer);
  }
  cost.composite_ms = watch.lapMs();
}

}  // namespace enfilade
