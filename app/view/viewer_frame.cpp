// How the viewer paints the window.
#include <fmt/format.h>

#include <cmath>

#include "app/view/pixel_marks.h"
#include "app/view/status_panel.h"
#include "app/view/viewer.h"
#include "app/view/world_marks.h"

namespace enfilade {

namespace {

constexpr float kFrustumShown = 4;  // [m]

}  // namespace

Camera Viewer::camera(const glm::ivec2& size) const {
  const glm::vec2 shape(glm::max(size, 1));
  Camera camera = lens_;
  camera.vertical_fov = fov_;
  camera.aspect = shape.x / shape.y;
  camera.pose = pose();
  return camera;
}

float Viewer::splitColumn() const { return std::round(split_at_ * overlay_.size().x); }

std::optional<glm::vec2> Viewer::freePointer() const {
  return window_.holdsPointer() ? std::nullopt : std::optional(pointer_);
}

void Viewer::paintWindow() {
  const glm::ivec2 size = window_.size();
  stale_ = false;
  if (size.x < 1 || size.y < 1) return;  // hidden
  theme_.scale = window_.contentScale();
  const glm::ivec2 painted = resolution_.sizeFor(size, moving_);
  if (painted != glm::ivec2(painter_.width(), painter_.height())) {
    painter_.resize(painted.x, painted.y);
  }
  const Camera camera = this->camera(size);
  overlay_.begin(size);
  const float middle = splitColumn() / static_cast<float>(size.x);
  paintPane(left_, camera, 0, split_ ? middle : 1);
  if (split_) paintPane(right_, camera, middle, 1);
  if (moving_) {
    resolution_.note(left_.history.last().frametime_ms +
                     (split_ ? right_.history.last().frametime_ms : 0));
  }
  overlay_.begin(size);
  if (split_) {
    overlay_.line({splitColumn(), 0}, {splitColumn(), overlay_.size().y}, 2 * theme_.scale,
                  Theme::kAccent);
  }
  if (show_panels_) paintPanels(camera);
  if (chooser_.isOpen()) chooser_.draw(overlay_, theme_, freePointer());
  if (show_help_) help_.draw(overlay_, theme_, freePointer());
  toast_.draw(overlay_, theme_);
  overlay_.end();
  if (keep_window_as_) keepWindow();
  window_.present();
}

void Viewer::paintPane(Pane& pane, const Camera& camera, float left, float right) {
  const glm::ivec2 size = window_.size();
  const PixelBox whole{glm::vec2(0), glm::vec2(size)};
  const auto width = static_cast<float>(size.x);
  const PixelBox part{{std::round(left * width), 0}, {std::round(right * width), whole.high.y}};
  pane.history.add(
      painter_.paint(pane.method, camera, {.chosen_for = frozen_, .wireframe = inspection_.wires}));
  pane.seen = painter_.visibleSet();
  const int slot = &pane == &left_ ? 0 : 1;
  if (pane.method == Method::kRaycast) {
    painter_.read(pane.rays);
    overlay_.begin(size);
    overlay_.clipTo(part);
    overlay_.picture(whole, pane.rays, slot);
    overlay_.end();
  } else {
    painter_.show(size, left, right);
  }
  const bool on_pixels = inspection_.images || inspection_.uncovered;
  if (on_pixels && infoOf(pane.method).portal_images) {
    markPixels(painter_, inspection_.images, inspection_.uncovered, pane.marks);
  } else {
    pane.marks = {};
  }
  overlay_.begin(size);
  overlay_.clipTo(part);
  overlay_.picture(whole, pane.marks, 2 + slot, true, false);
  paintMarks(pane, camera, whole);
  overlay_.end();
  // Images that are made or read while walking go on being so while one stands.
  if (pane.history.last().capture_ms.value_or(0) > 0.05) stale_ = true;
  if (LimitedImages* const limited = walkable_.images->limited()) {
    if (limited->isLoading()) stale_ = true;
    if (const auto complaint = limited->complaint()) toast_.say(*complaint);
  }
}

void Viewer::paintMarks(const Pane& pane, const Camera& camera, const PixelBox& box) {
  WorldMarks marks(overlay_, theme_, camera, box);
  if (inspection_.portals) marks.portals(house_.graph, pane.seen);
  if (inspection_.names) marks.names(house_.graph, pane.seen);
  if (frozen_) marks.frustum(*frozen_, kFrustumShown);
}

std::string Viewer::placeLine() const {
  const glm::vec3 eye = pose().position;
  const CellLocation where = locate(house_.graph, house_.grid, eye);
  const Cell& cell = house_.graph.cells[where.cell];
  return fmt::format("{}{} ({:.1f}, {:.1f}, {:.1f})", where.in_free_space ? "" : "in a wall by ",
                     cell.name, eye.x, eye.y, eye.z);
}

std::string Viewer::notesLine() const {
  std::string notes;
  const auto add = [&](bool holds, const char* note) {
    if (holds) notes += (notes.empty() ? "" : " · ") + std::string(note);
  };
  add(recorder_.has_value(), "recording");
  add(playing_ != nullptr, "playing the tour");
  add(walker_.flying(), "flying");
  add(frozen_.has_value(), "culling frozen");
  add(moving_ && resolution_.reduced(), "coarser while moving");
  return notes;
}

void Viewer::paintPanels(const Camera& camera) {
  const float margin = theme_.margin();
  const bool graph = options_.settings.show_graph;
  drawStatus(overlay_, theme_, glm::vec2(margin), false,
             {left_.method, placeLine(), notesLine(), graph}, left_.history);
  if (split_) {
    drawStatus(overlay_, theme_, {overlay_.size().x - margin, margin}, true,
               {right_.method, "", "", graph}, right_.history);
  }
  if (!options_.settings.show_plan) return;
  PlanMarks marks;
  marks.camera = camera;
  marks.seen = left_.seen.cells.empty() ? nullptr : &left_.seen;
  marks.frozen = frozen_;
  marks.pointer = freePointer();
  if (recorder_.has_value()) marks.path = &trail_;
  plan_.draw(overlay_, theme_, overlay_.size() - glm::vec2(margin), marks);
}

}  // namespace enfilade
