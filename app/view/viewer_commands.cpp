// What the viewer does when it is told to.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/view/viewer.h"
#include "portals/open_doors.h"

namespace enfilade {

namespace {

constexpr float kDoorReach = 2.5f;                  // [m]
constexpr float kSlowest = 0.1f, kFastest = 20.0f;  // [m/s]
constexpr float kNarrowest = 20, kWidest = 120;     // [degrees]

const char* onOff(bool on) { return on ? "on" : "off"; }

}  // namespace

void Viewer::perform(const Command& command) {
  stale_ = true;
  ViewSettings& settings = options_.settings;
  switch (command.action) {
    case Action::kMethod:
      return setMethod(left_, command.number);
    case Action::kSplitMethod:
      if (!split_) toggleSplit();
      return setMethod(right_, command.number);
    case Action::kSplit:
      return toggleSplit();
    case Action::kFly:
      takeOver();
      walker_.setFlying(!walker_.flying());
      return toast_.say(walker_.flying() ? "Flying: E and Q go up and down" : "Walking");
    case Action::kDoor:
      return toggleDoor();
    case Action::kFaster:
      return changeSpeed(1.25f);
    case Action::kSlower:
      return changeSpeed(0.8f);
    case Action::kWider:
      return changeFieldOfView(5);
    case Action::kNarrower:
      return changeFieldOfView(-5);
    case Action::kJump:
      controls_.release();
      window_.holdPointer(false);
      return chooser_.open();
    case Action::kStart:
      return goToStart();
    case Action::kRecord:
      return toggleRecording();
    case Action::kPlayTour:
      return toggleTour();
    case Action::kPlan:
      settings.show_plan = !settings.show_plan;
      return;
    case Action::kPlanStorey:
      return plan_.turnPage();
    case Action::kGraph:
      settings.show_graph = !settings.show_graph;
      return;
    case Action::kPanels:
      show_panels_ = !show_panels_;
      return;
    case Action::kHelp:
      show_help_ = !show_help_;
      if (show_help_) window_.holdPointer(false);
      return;
    case Action::kFullScreen:
      window_.setFullScreen(!window_.fullScreen());
      return;
    case Action::kScreenshot:
      return keepPicture();
    case Action::kWindowShot:
      keep_window_as_ = keepName(".png");
      return;
    case Action::kFreePointer:
      if (!show_help_) window_.holdPointer(false);
      show_help_ = false;
      return toast_.dismiss();
    case Action::kQuit:
      return window_.close();
    default:
      return performInspection(command.action);
  }
}

void Viewer::performInspection(Action action) {
  const auto toggle = [&](bool& flag, const char* what) {
    flag = !flag;
    toast_.say(fmt::format("{}: {}", what, onOff(flag)));
  };
  switch (action) {
    case Action::kFreeze:
      return toggleFreeze();
    case Action::kPortals:
      return toggle(inspection_.portals, "Portals' outlines");
    case Action::kNames:
      return toggle(inspection_.names, "Cells' names");
    case Action::kImages:
      return toggle(inspection_.images, "Images tinted");
    case Action::kUncovered:
      return toggle(inspection_.uncovered, "Uncovered pixels marked");
    case Action::kWires:
      return toggle(inspection_.wires, "Wire frame");
    case Action::kSteady: {
      bool fixed = resolution_.fixed();
      toggle(fixed, "Full resolution while moving");
      return resolution_.setFixed(fixed);
    }
    case Action::kLayers:
      toggle(inspection_.layers, "Layers coloured (1 green, 2 yellow, 3 orange, 4 and on red)");
      if (inspection_.layers) {
        painter_.setStandIn([this](const Ldi& image) { return layer_colors_.of(image); });
      } else {
        painter_.setStandIn({});
        layer_colors_ = {};
      }
      return;
    default:
      return;
  }
}

void Viewer::setMethod(Pane& pane, int number) {
  const auto count = static_cast<int>(allMethods().size());
  const int current = static_cast<int>(pane.method);
  // A controller's buttons go to the one before or after.
  const int index = number > 0 ? number - 1 : (current + (number == -1 ? count - 1 : 1)) % count;
  if (index >= count) return;
  const MethodInfo& method = allMethods()[static_cast<std::size_t>(index)];
  bool has_images = true;
  if (options_.source == ImageSource::kBaked) has_images = walkable_.images->fetch(method);
  pane.method = method.method;
  pane.history.clear();
  painter_.prepare(pane.method);
  const std::string note = walkable_.images->noteOn(method);
  if (!note.empty()) return toast_.say(note);
  toast_.say(has_images ? fmt::format("{}: {}", method.name, method.description)
                        : fmt::format("{}: the house has no images for it; bake them, or view "
                                      "with --images on-demand",
                                      method.name));
}

void Viewer::toggleSplit() {
  split_ = !split_;
  if (!split_) return;
  right_.history.clear();
  if (right_.method == left_.method) {
    right_.method = left_.method == Method::kGeometry ? Method::kLdi : Method::kGeometry;
  }
  setMethod(right_, static_cast<int>(right_.method) + 1);
  toast_.say(fmt::format("{} | {}: Shift 1…7 chooses the right one; Esc, then drag the line",
                         infoOf(left_.method).name, infoOf(right_.method).name));
}

void Viewer::toggleDoor() {
  const glm::vec3 eye = pose().position;
  const glm::vec3 ahead = pose().world_from_camera_rotation * glm::vec3(0, 0, -1);
  float best = kDoorReach;
  std::optional<PortalId> door;
  for (PortalId id = 0; id < closable_.size(); ++id) {
    if (!closable_[id]) continue;
    const glm::vec3 way = house_.graph.portals[id].center() - eye;
    const float distance = glm::length(glm::vec2(way.x, way.z));
    const bool level = std::abs(way.y) < 2;
    // One that is looked at is taken before one beside or behind.
    const float weighed = distance * (glm::dot(way, ahead) > 0 ? 1.0f : 2.0f);
    if (level && weighed < best) best = weighed, door = id;
  }
  if (!door) return toast_.say("No door with a leaf is near");
  const bool opens = open_[*door] == 0;
  for (PortalId id = 0; id < open_.size(); ++id) {
    if (house_.graph.portals[id].polygon == house_.graph.portals[*door].polygon) open_[id] = opens;
  }
  painter_.setDoors(open_);
  walker_.setDoors(open_);
  const std::string& name = house_.graph.portals[*door].name;
  if (recorder_) recorder_->addDoors(clock_, open_);
  toast_.say(fmt::format("{} {}", name, opens ? "opens" : "shuts"));
}

void Viewer::toggleFreeze() {
  if (frozen_) {
    frozen_.reset();
    return toast_.say("Culling follows you again");
  }
  frozen_ = camera(window_.size());
  toast_.say("Culling is frozen: walk or fly (F) away and look at what is drawn");
}

void Viewer::goTo(CellId cell) {
  playing_.reset();
  held_pose_.reset();
  const bool stands = walker_.placeInCell(cell);
  toast_.say(house_.graph.cells[cell].name + (stands ? "" : ": no place to stand, so you fly"));
}

void Viewer::goTo(const glm::vec3& eye) {
  playing_.reset();
  held_pose_.reset();
  walker_.place(eye);
}

void Viewer::changeSpeed(float factor) {
  speed_ = std::clamp(speed_ * factor, kSlowest, kFastest);
  toast_.say(fmt::format("{:.1f} m/s", speed_));
}

void Viewer::changeFieldOfView(float degrees) {
  const float now = std::clamp(glm::degrees(fov_) + degrees, kNarrowest, kWidest);
  fov_ = glm::radians(now);
  toast_.say(fmt::format("Field of view {:.0f}° from top to bottom", now));
}

}  // namespace enfilade
