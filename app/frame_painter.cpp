#include "app/frame_painter.h"

#include <algorithm>

#include "app/stopwatch.h"
#include "portals/leaf_cover.h"
#include "scene/error.h"
#include "visibility/eye_culling.h"

namespace enfilade {

namespace {

/// The portals that show images, where another eye sees them: whole, from the side of their image.
void lookFromElsewhere(const CellGraph& graph, const View& view, VisibleSet& set) {
  std::erase_if(set.portals, [&](const VisiblePortal& seen) {
    const float before = graph.portals[seen.portal].plane.signedDistance(view.eye);
    return seen.as_image && (seen.from_front ? before : -before) <= 0;
  });
  for (VisiblePortal& seen : set.portals) {
    if (!seen.as_image) continue;
    const std::vector<glm::vec3> polygon = screenPolygonOf(graph.portals[seen.portal]).polygon;
    seen.regions = {clipRegion(view, wholeScreen(view), polygon)};
    if (seen.regions.front().empty()) seen.regions.clear();
  }
}

}  // namespace

ImageSource parseImageSource(const std::string& name) {
  if (name == "baked") return ImageSource::kBaked;
  if (name == "on-demand") return ImageSource::kOnDemand;
  throw Error(ErrorKind::kUsage, "--images " + name, "no such source; there are: baked, on-demand");
}

FramePainter::FramePainter(GlContext& context, House& house, const PortalImages& images, int width,
                           int height, int threads, ImageSource source)
    : house_(house),
      objects_(house),
      renderer_(context, house.building),
      baked_(images),
      source_(source),
      pictures_(house, width, height, threads),
      width_(width),
      height_(height),
      threads_(threads) {
  lookThroughShutPortals(house_, objects_.leaves());
  if (source == ImageSource::kBaked) return;
  for (const MethodInfo& method : allMethods()) {
    if (method.portal_images)
      makers_.try_emplace(method.method, method, house, objects_, renderer_);
  }
}

void FramePainter::resize(int width, int height) {
  width_ = width;
  height_ = height;
  pictures_.resize(width, height);
}

void FramePainter::buildRays() {
  if (rays_) return;
  std::vector<std::uint8_t> leaves(house_.building.objects.size(), 0);
  for (const DoorLeaf& leaf : objects_.leaves()) leaves[leaf.object] = 1;
  rays_ = std::make_unique<RayCaster>(house_.building, objects_.openDoors(), threads_, leaves);
}

void FramePainter::setDoors(std::span<const std::uint8_t> open) {
  bool changed = false;
  for (std::size_t p = 0; p < open.size(); ++p) {
    Portal& portal = house_.graph.portals[p];
    if (portal.active == (open[p] != 0)) continue;
    changed = true;
    portal.active = open[p] != 0;
    if (!portal.active) {
      portal.seen_within = seenWithinWhenShut(house_, static_cast<PortalId>(p), objects_.leaves());
    }
  }
  if (!changed) return;
  objects_.setDoors(house_);
  if (rays_) rays_->setHidden(objects_.openDoors());
  for (auto& [method, maker] : makers_) maker.forget();
}

void FramePainter::prepare(Method method) {
  if (method == Method::kRaycast) buildRays();
  const auto maker = makers_.find(method);
  if (maker != makers_.end()) maker->second.forget();
  if (isLimited(infoOf(method))) limited_->begin(infoOf(method));
}

FrameCost FramePainter::paint(Method method, const Camera& camera, const PaintOptions& options) {
  if (method == Method::kRaycast) buildRays();
  seen_.clear();
  set_ = {};
  renderer_.setWireframe(options.wireframe);
  FrameCost cost;
  const MethodInfo& info = infoOf(method);
  const Stopwatch watch;
  if (method == Method::kRaycast) {
    paintRays(camera, cost);
  } else if (info.by_cells) {
    paintCells(camera, info, options, cost);
  } else {
    paintView(camera, options, cost);
  }
  cost.frametime_ms = watch.totalMs();
  last_by_rays_ = method == Method::kRaycast;
  clip_from_world_ = camera.clipFromWorld();
  return cost;
}

void FramePainter::paintView(const Camera& camera, const PaintOptions& options, FrameCost& cost) {
  Stopwatch watch;
  const View view = camera.view();
  objects_.inFrustum(options.chosen_for.value_or(camera).view(), in_view_);
  cost.cull_ms = watch.lapMs();
  renderer_.begin(width_, height_);
  cost.triangles = renderer_.draw(in_view_.objects, view).triangles;
  renderer_.finish();
  cost.draw_ms = watch.lapMs();
}

void FramePainter::paintRays(const Camera& camera, FrameCost& cost) {
  Stopwatch watch;
  rays_->render(camera, width_, height_, ray_picture_);
  cost.draw_ms = watch.lapMs();
}

const PortalImages& FramePainter::imagesOf(const MethodInfo& method) const {
  return source_ == ImageSource::kBaked ? baked_ : makers_.at(method.method).images();
}

bool FramePainter::isThere(const MethodInfo& method, PortalId portal, bool from_front) const {
  if (isLimited(method)) return limited_->shows(sideIndex(portal, from_front));
  return imagesOf(method).side(portal, from_front).has(method.image_kind);
}

VisibleSet FramePainter::cull(const View& view, const MethodInfo& method,
                              const std::optional<PortalSide>& as_geometry) const {
  ShowAsImage show_as_image;
  if (method.portal_images) {
    show_as_image = [&](const Portal& portal, PortalId id, bool from_front) {
      return portal.active && as_geometry != PortalSide{id, from_front} &&
             isThere(method, id, from_front) && isBeyondSwitch(house_, view.eye, id, from_front);
    };
  }
  return cullFromEye(house_.graph, house_.grid, view, show_as_image);
}

VisibleSet FramePainter::cullAndMake(const View& view, const MethodInfo& method,
                                     const std::optional<PortalSide>& as_geometry,
                                     FrameCost& cost) {
  Stopwatch watch;
  double load_ms = 0;
  if (isLimited(method)) {
    limited_->beginFrame(method, frame_);
    load_ms = watch.lapMs();
  }
  VisibleSet set = cull(view, method, as_geometry);
  cost.cull_ms = watch.lapMs();
  if (isLimited(method)) {
    limited_->bringIn(set);
    cost.load_ms = load_ms + watch.lapMs();
  }
  const auto maker = makers_.find(method.method);
  if (maker == makers_.end()) return set;
  const bool made = maker->second.makeOne(set, view.eye);
  cost.capture_ms = watch.lapMs();
  if (made) set = cull(view, method, as_geometry);
  *cost.cull_ms += watch.lapMs();
  return set;
}

void FramePainter::paintCells(const Camera& camera, const MethodInfo& method,
                              const PaintOptions& options, FrameCost& cost) {
  const View view = camera.view();
  const Camera chosen_for = options.chosen_for.value_or(camera);
  set_ = cullAndMake(chosen_for.view(), method, options.as_geometry, cost);
  Stopwatch watch;
  objects_.visible(set_, in_view_);
  if (options.chosen_for) lookFromElsewhere(house_.graph, view, set_);
  *cost.cull_ms += watch.lapMs();
  cost.cells = set_.cells.size();
  cost.portals = set_.portals.size();
  for (const VisiblePortal& portal : set_.portals) {
    seen_.push_back({{portal.portal, portal.from_front}, portal.as_image});
  }
  renderer_.begin(width_, height_);
  double draw_ms = watch.lapMs();
  if (method.portal_images) {
    pictures_.draw(method, imagesOf(method), set_, chosen_for.pose.position, camera, renderer_,
                   cost);
  }
  watch.lapMs();
  if (isLimited(method)) {
    limited_->endFrame(set_, chosen_for.pose.position, cost);
    *cost.load_ms += watch.lapMs();
  }
  cost.triangles = renderer_.draw(in_view_.objects, view).triangles;
  renderer_.finish();
  cost.draw_ms = draw_ms + watch.lapMs();
}

void FramePainter::read(Image& out) {
  if (last_by_rays_) {
    out = ray_picture_;
  } else {
    renderer_.readColor(out);
  }
}

void FramePainter::readPortalMask(PortalMask& out) {
  out.sides.clear();
  out.of_pixel.clear();
  std::vector<ScreenPolygon> polygons;
  for (const SeenPortal& seen : seen_) {
    if (!seen.as_image) continue;
    out.sides.push_back(seen.side);
    polygons.push_back(screenPolygonOf(house_.graph.portals[seen.side.portal]));
  }
  if (!polygons.empty()) renderer_.readVisible(polygons, clip_from_world_, out.of_pixel);
}

Camera walkingCamera(const House& house, float vertical_fov, int width, int height) {
  Camera camera;
  camera.vertical_fov = vertical_fov;
  camera.aspect = static_cast<float>(width) / static_cast<float>(height);
  const Box bounds = worldBounds(house.building);
  // A walker may stand outside, about as far from the building as the building is large.
  if (!bounds.empty()) camera.far_plane = std::max(100.0f, 2.0f * glm::length(bounds.size()));
  return camera;
}

}  // namespace enfilade
