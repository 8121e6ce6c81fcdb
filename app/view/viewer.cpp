#include "app/view/viewer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/interruption.h"
#include "app/stopwatch.h"
#include "portals/open_doors.h"

namespace enfilade {

namespace {

constexpr double kIdleWait = 0.25;     // [s] between looks at what has no events
constexpr double kGamepadWait = 0.02;  // [s] likewise, with a controller, which has none
constexpr float kLongestStep = 0.5f;   // [s] that a frame moves on, however long it took
constexpr float kRunning = 2.5f;       // times the speed
constexpr float kAtRest = 0.01f;       // [m/s]
constexpr float kLevel = 0.002f;       // [m]

}  // namespace

Viewer::Viewer(GlfwWindow& window, WalkableHouse& walkable, const ViewOptions& options)
    : window_(window),
      walkable_(walkable),
      house_(walkable.house),
      walker_(*walkable.walker),
      options_(options),
      painter_(window, house_, walkable.images->images(), std::max(window.size().x, 1),
               std::max(window.size().y, 1), options.threads, options.source),
      overlay_(window),
      plan_(house_),
      chooser_(house_.graph),
      lens_(walkingCamera(house_, 1, 1, 1)),
      fov_(glm::radians(options.settings.fov_degrees)),
      speed_(options.settings.speed),
      closable_(closablePortals(house_)),
      path_(walkable.tour) {
  painter_.setWarping(options.warping);
  painter_.setLimited(walkable.images->limited());
  for (const Portal& portal : house_.graph.portals) open_.push_back(portal.active ? 1 : 0);
  stored_ = open_;
  left_.method = parseMethods(options.settings.method).front();
  right_.method = Method::kGeometry;
  if (!walkable.method_has_images) {
    toast_.say(
        fmt::format("The house has no images for {}: it shows geometry", options.settings.method));
  } else if (const auto note = walkable.images->noteOn(infoOf(left_.method)); !note.empty()) {
    toast_.say(note);
  } else {
    toast_.say("Click to look around · F1 shows the keys");
  }
  painter_.prepare(left_.method);
  perform({Action::kStart});
}

ViewSettings Viewer::settings() const {
  ViewSettings settings = options_.settings;
  settings.house = options_.house;
  settings.width = window_.placeSize().x;
  settings.height = window_.placeSize().y;
  settings.fullscreen = window_.fullScreen();
  settings.method = infoOf(left_.method).name;
  settings.fov_degrees = glm::degrees(fov_);
  settings.speed = speed_;
  return settings;
}

void Viewer::run() {
  Stopwatch watch;
  bool idle = true;
  GamepadState pad = window_.gamepad();
  while (!window_.shouldClose() && !Interruption::asked()) {
    const double wait = !idle ? 0 : pad.there ? kGamepadWait : kIdleWait;
    const bool toasted = toast_.shows();
    for (const WindowEvent& event : window_.takeEvents(wait)) take(event);
    std::vector<Command> commands;
    pad = window_.gamepad();
    controls_.take(pad, commands);
    for (const Command& command : commands) perform(command);
    const auto passed = static_cast<float>(watch.lapMs() / 1000);
    // Whoever begins to move after a rest has not moved while waiting.
    move(idle ? std::min(passed, 1.0f / 60) : std::min(passed, kLongestStep));
    if (toasted && !toast_.shows()) stale_ = true;
    if (stale_) paintWindow();
    idle = !stale_ && !moving_;
  }
}

void Viewer::move(float seconds) {
  clock_ += static_cast<double>(seconds);
  const auto height = static_cast<float>(std::max(window_.size().y, 1));
  const float sensitivity = options_.settings.mouse_sensitivity;
  Steering steering = controls_.steer(seconds, sensitivity * fov_ / height);
  if (options_.settings.invert_y) steering.pitch = -steering.pitch;
  if (playing_ && (steering.stride.forward != 0 || steering.stride.right != 0)) {
    playing_.reset();
    toast_.say("The tour stops where you take over");
  }
  const bool was_moving = moving_;
  if (playing_) {
    advanceTour(seconds);
    moving_ = playing_ != nullptr;
  } else {
    if (steering.any()) takeOver();
    Gait gait = walker_.gait();
    gait.speed = steering.running ? kRunning * speed_ : speed_;
    walker_.setGait(gait);
    walker_.turn(steering.yaw, steering.pitch);
    if (!held_pose_) walker_.step(steering.stride, seconds);
    moving_ = steering.any() || coasts();
  }
  if (recorder_) {
    if (!recorder_->addFrame(clock_, pose())) toggleRecording();
    moving_ = true;  // standing still is a part of the path
    const glm::vec3 eye = pose().position;
    if (trail_.empty() || glm::length(eye - trail_.back()) > 0.05f) trail_.push_back(eye);
  }
  if (moving_ || was_moving) stale_ = true;
}

/// Whether it goes on moving by itself: it slows down, or the eye follows a step.
bool Viewer::coasts() const {
  if (held_pose_) return false;
  if (glm::length(walker_.velocity()) > kAtRest) return true;
  const float level = walker_.floorHeight() + walker_.gait().eye_height;
  return std::abs(level - walker_.eye().y) > kLevel;  // false while flying, as there is no level
}

void Viewer::standAt(const Pose& pose) {
  takeOver();
  held_pose_ = pose;
}

/// From where a path has led on, one goes by oneself.
void Viewer::takeOver() {
  if (!held_pose_) return;
  const glm::vec3 ahead = held_pose_->world_from_camera_rotation * glm::vec3(0, 0, -1);
  walker_.place(held_pose_->position);
  const float yaw = std::abs(ahead.x) + std::abs(ahead.z) > 1e-4f ? std::atan2(-ahead.x, -ahead.z)
                                                                  : walker_.yaw();
  walker_.look(yaw, std::asin(std::clamp(ahead.y, -1.0f, 1.0f)));
  held_pose_.reset();
}

void Viewer::goToStart() {
  playing_.reset();
  if (path_ && !path_->poses.empty()) return standAt(path_->poses.front().pose);
  held_pose_.reset();
  walker_.setFlying(false);
  walker_.placeInCell(walker_.ground().startCell());
}

void Viewer::advanceTour(float seconds) {
  play_time_ += static_cast<double>(seconds);
  if (const auto* doors = playing_->doorsAt(play_time_)) {
    if (*doors != open_) {
      open_ = *doors;
      painter_.setDoors(open_);
      walker_.setDoors(open_);
    }
  }
  held_pose_ = playing_->poseAt(play_time_);
  if (play_time_ < playing_->duration()) return;
  playing_.reset();
  toast_.say("The tour is over");
}

void Viewer::take(const WindowEvent& event) {
  using Kind = WindowEvent::Kind;
  stale_ = stale_ || event.kind != Kind::kMouseMove || window_.holdsPointer() || show_help_ ||
           chooser_.isOpen() || dragging_ || plan_.covers(event.at) || plan_.covers(pointer_);
  if (chooser_.isOpen() && !event.control) {
    if (event.kind == Kind::kMouseMove) pointer_ = event.at;
    if (const auto cell = chooser_.take(event)) goTo(*cell);
    return;
  }
  if (takePointer(event)) return;
  controls_.take(event, window_.holdsPointer());
  if (event.kind == Kind::kScroll) changeSpeed(std::pow(1.15f, event.at.y));
  if (event.kind == Kind::kFocusLost) window_.holdPointer(false);
  const bool repeats = event.kind == Kind::kKeyRepeat && !event.control;
  if (event.kind != Kind::kKeyDown && !repeats) return;
  const std::optional<Command> command = commandOf(event);
  if (!command) return;
  const bool may_repeat = command->action == Action::kFaster ||
                          command->action == Action::kSlower || command->action == Action::kWider ||
                          command->action == Action::kNarrower;
  if (event.kind == Kind::kKeyDown || may_repeat) perform(*command);
}

/// Clicks and drags; whether the event was one.
bool Viewer::takePointer(const WindowEvent& event) {
  using Kind = WindowEvent::Kind;
  if (window_.holdsPointer()) return false;
  if (event.kind == Kind::kMouseMove) {
    pointer_ = event.at;
    const float width = overlay_.size().x;
    if (dragging_) split_at_ = std::clamp(pointer_.x / std::max(width, 1.0f), 0.02f, 0.98f);
    return true;
  }
  if (event.kind == Kind::kMouseUp) dragging_ = false;
  if (event.kind != Kind::kMouseDown || event.button != MouseButton::kLeft) return false;
  pointer_ = event.at;
  if (show_help_) {
    if (const auto command = help_.commandAt(pointer_)) {
      perform(*command);
    } else {
      show_help_ = false;
    }
  } else if (show_panels_ && options_.settings.show_plan && plan_.covers(pointer_)) {
    if (const auto place = plan_.placeAt(pointer_)) goTo(*place);
  } else if (split_ && std::abs(pointer_.x - splitColumn()) < 8 * theme_.scale) {
    dragging_ = true;
  } else {
    window_.holdPointer(true);
  }
  return true;
}

}  // namespace enfilade
