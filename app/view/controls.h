#pragma once

#include <array>
#include <set>
#include <vector>

#include "app/view/actions.h"
#include "app/walker.h"

namespace enfilade {

/// What the controls ask for in a frame.
struct Steering {
  Stride stride;
  bool running = false;
  float yaw = 0, pitch = 0;  ///< [rad] to turn by
  bool any() const {
    return stride.forward != 0 || stride.right != 0 || stride.up != 0 || yaw != 0 || pitch != 0;
  }
};

/// Held keys, the mouse and a controller as steering.  A key that was pressed and let go between
/// two frames counts as held for one, so that no press is lost however slow the frames are.
class Controls {
 public:
  void take(const WindowEvent& event, bool pointer_held);
  void take(const GamepadState& pad, std::vector<Command>& commands);

  /// What is asked for in the `seconds` since the last call.  `radians_per_pixel`: of the mouse.
  Steering steer(float seconds, float radians_per_pixel);

  void release();  ///< nothing is held any more

 private:
  bool holds(Key place) const { return held_.contains(place) || tapped_.contains(place); }

  std::set<Key> held_, tapped_;  // by place
  glm::vec2 moved_{0};           // by the mouse since the last call [pixels]
  GamepadState pad_;
};

}  // namespace enfilade
