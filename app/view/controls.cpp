#include "app/view/controls.h"

#include <algorithm>

namespace enfilade {

namespace {

constexpr float kKeyTurn = 1.6f;  // [rad/s] by the arrow keys
constexpr float kPadTurn = 2.4f;  // [rad/s] by a stick pushed through

}  // namespace

void Controls::take(const WindowEvent& event, bool pointer_held) {
  using Kind = WindowEvent::Kind;
  switch (event.kind) {
    case Kind::kKeyDown:
      if (event.control) return;  // a command
      held_.insert(event.place);
      tapped_.insert(event.place);
      return;
    case Kind::kKeyUp:
      held_.erase(event.place);
      return;
    case Kind::kMouseMove:
      if (pointer_held) moved_ += event.at;
      return;
    case Kind::kFocusLost:
      release();
      return;
    default:
      return;
  }
}

void Controls::take(const GamepadState& pad, std::vector<Command>& commands) {
  const auto pressed = [&](bool GamepadState::*button) { return pad.*button && !(pad_.*button); };
  if (pressed(&GamepadState::a)) commands.push_back({Action::kDoor});
  if (pressed(&GamepadState::b)) commands.push_back({Action::kFly});
  if (pressed(&GamepadState::x)) commands.push_back({Action::kSplit});
  if (pressed(&GamepadState::y)) commands.push_back({Action::kPlan});
  if (pressed(&GamepadState::start)) commands.push_back({Action::kHelp});
  if (pressed(&GamepadState::back)) commands.push_back({Action::kStart});
  if (pressed(&GamepadState::left_bumper)) commands.push_back({Action::kMethod, -1});
  if (pressed(&GamepadState::right_bumper)) commands.push_back({Action::kMethod, -2});
  pad_ = pad;
}

Steering Controls::steer(float seconds, float radians_per_pixel) {
  const auto axis = [&](bool plus, bool minus, float stick) {
    const float keys = (plus ? 1.0f : 0.0f) - (minus ? 1.0f : 0.0f);
    return std::clamp(keys + stick, -1.0f, 1.0f);
  };
  Steering steering;
  steering.stride.forward =
      axis(holds('W') || holds(key::kUp), holds('S') || holds(key::kDown), -pad_.left.y);
  steering.stride.right = axis(holds('D'), holds('A'), pad_.left.x);
  steering.stride.up = axis(holds('E') || holds(key::kPageUp), holds('Q') || holds(key::kPageDown),
                            pad_.right_trigger - pad_.left_trigger);
  steering.running = holds(key::kLeftShift) || holds(key::kRightShift);
  const float turn = axis(holds(key::kLeft), holds(key::kRight), 0);
  steering.yaw =
      (kKeyTurn * turn - kPadTurn * pad_.right.x) * seconds - radians_per_pixel * moved_.x;
  steering.pitch = -kPadTurn * pad_.right.y * seconds - radians_per_pixel * moved_.y;
  tapped_.clear();
  moved_ = glm::vec2(0);
  return steering;
}

void Controls::release() {
  held_.clear();
  tapped_.clear();
  moved_ = glm::vec2(0);
}

}  // namespace enfilade
