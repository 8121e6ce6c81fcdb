#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <string>

namespace enfilade {

/// A key by the capital letter, digit or sign on it ('A', '1', '['), or one of those below.
using Key = int;

namespace key {
inline constexpr Key kEscape = 256, kEnter = 257, kTab = 258, kBackspace = 259;
inline constexpr Key kRight = 262, kLeft = 263, kDown = 264, kUp = 265;
inline constexpr Key kPageUp = 266, kPageDown = 267, kHome = 268, kEnd = 269;
inline constexpr Key kF1 = 290, kF2 = 291, kF3 = 292, kF4 = 293, kF5 = 294, kF6 = 295, kF7 = 296,
                     kF8 = 297, kF9 = 298, kF10 = 299, kF11 = 300, kF12 = 301;
inline constexpr Key kLeftShift = 340, kLeftControl = 341, kRightShift = 344, kRightControl = 345;
}  // namespace key

/// What a key is called: "F1", "Page up", "A".
std::string keyName(Key key);

enum class MouseButton : std::uint8_t { kLeft, kRight, kOther };

/// Something that happened in a window.
struct WindowEvent {
  enum class Kind : std::uint8_t {
    kKeyDown,
    kKeyRepeat,
    kKeyUp,
    kText,       ///< `character` was typed
    kMouseMove,  ///< `at` is where the pointer is, or while it is held how far it went
    kMouseDown,
    kMouseUp,
    kScroll,     ///< `at`: x and y of the wheel
    kFocusLost,  ///< what was held is held no more
    kRedraw,     ///< its size changed, or what it shows was lost
  };
  Kind kind = Kind::kRedraw;
  Key key = 0;    ///< by what is printed on it
  Key place = 0;  ///< by where it is: what stands there on an American keyboard
  bool shift = false, control = false;
  char32_t character = 0;
  MouseButton button = MouseButton::kLeft;
  glm::vec2 at{0};  ///< [pixels of the frame], y down
};

/// What a game controller's sticks and buttons say, with the names of the Xbox layout.
struct GamepadState {
  bool there = false;
  glm::vec2 left{0}, right{0};  ///< −1…1, x to the right, y down; 0 within its dead zone
  float left_trigger = 0;       ///< 0…1
  float right_trigger = 0;      ///< 0…1
  bool a = false, b = false, x = false, y = false;
  bool left_bumper = false, right_bumper = false, back = false, start = false;
};

}  // namespace enfilade
