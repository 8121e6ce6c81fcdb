#include "render/glfw_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <utility>

#include "scene/error.h"

namespace enfilade {

namespace {

using Kind = WindowEvent::Kind;

constexpr float kDeadZone = 0.15f;  // sticks seldom rest at 0

static_assert(key::kEscape == GLFW_KEY_ESCAPE && key::kBackspace == GLFW_KEY_BACKSPACE);
static_assert(key::kRight == GLFW_KEY_RIGHT && key::kUp == GLFW_KEY_UP);
static_assert(key::kPageUp == GLFW_KEY_PAGE_UP && key::kEnd == GLFW_KEY_END);
static_assert(key::kF1 == GLFW_KEY_F1 && key::kF12 == GLFW_KEY_F12);
static_assert(key::kLeftShift == GLFW_KEY_LEFT_SHIFT);
static_assert(key::kRightControl == GLFW_KEY_RIGHT_CONTROL);

[[noreturn]] void failWithoutWindow() {
  const char* reason = nullptr;
  glfwGetError(&reason);
  throw Error(ErrorKind::kMachine, "window",
              std::string(reason != nullptr ? reason : "cannot be opened") +
                  "; 'enfilade play' needs no display");
}

/// A key by what is printed on it in the person's own layout, if that is a character of ASCII.
/// Digits are where they always are, though some layouts want Shift for them.
Key keyOf(int code, int scancode) {
  const char* name = glfwGetKeyName(code, scancode);
  const bool sign = code > 32 && code < 256 && !(code >= '0' && code <= '9');
  if (!sign || name == nullptr || name[0] == 0 || name[1] != 0) return code;
  const char c = name[0];
  return c >= 'a' && c <= 'z' ? c - 'a' + 'A' : c;
}

glm::vec2 stick(float x, float y) {
  const glm::vec2 raw(x, y);
  const float far = glm::length(raw);
  if (!(far > kDeadZone)) return glm::vec2(0);
  return raw / far * std::min((far - kDeadZone) / (1 - kDeadZone), 1.0f);
}

}  // namespace

/// What GLFW calls.
struct GlfwWindow::Callbacks {
  static GlfwWindow& of(GLFWwindow* window) {
    return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window));
  }

  static void onKey(GLFWwindow* window, int code, int scancode, int action, int mods) {
    if (code == GLFW_KEY_UNKNOWN) return;
    WindowEvent event;
    event.kind = action == GLFW_PRESS    ? Kind::kKeyDown
                 : action == GLFW_REPEAT ? Kind::kKeyRepeat
                                         : Kind::kKeyUp;
    event.key = keyOf(code, scancode);
    event.place = code;
    event.shift = (mods & GLFW_MOD_SHIFT) != 0;
    event.control = (mods & GLFW_MOD_CONTROL) != 0;
    of(window).events_.push_back(event);
  }

  static void onText(GLFWwindow* window, unsigned character) {
    WindowEvent event;
    event.kind = Kind::kText;
    event.character = character;
    of(window).events_.push_back(event);
  }

  /// Screen units to pixels: they differ where the system scales windows.
  static glm::vec2 toPixels(GLFWwindow* window, const glm::dvec2& units) {
    glm::ivec2 in_units(1), in_pixels(1);
    glfwGetWindowSize(window, &in_units.x, &in_units.y);
    glfwGetFramebufferSize(window, &in_pixels.x, &in_pixels.y);
    return glm::vec2(units * glm::dvec2(in_pixels) / glm::dvec2(glm::max(in_units, 1)));
  }

  static void onPointer(GLFWwindow* window, double x, double y) {
    GlfwWindow& self = of(window);
    const glm::dvec2 now(x, y);
    const glm::dvec2 before = std::exchange(self.pointer_, now);
    WindowEvent event;
    event.kind = Kind::kMouseMove;
    event.at = toPixels(window, self.holdsPointer() ? now - before : now);
    self.events_.push_back(event);
  }

  static void onButton(GLFWwindow* window, int button, int action, int mods) {
    WindowEvent event;
    event.kind = action == GLFW_PRESS ? Kind::kMouseDown : Kind::kMouseUp;
    event.button = button == GLFW_MOUSE_BUTTON_LEFT    ? MouseButton::kLeft
                   : button == GLFW_MOUSE_BUTTON_RIGHT ? MouseButton::kRight
                                                       : MouseButton::kOther;
    event.shift = (mods & GLFW_MOD_SHIFT) != 0;
    // Where it was then: by now it may be elsewhere.
    event.at = toPixels(window, of(window).pointer_);
    of(window).events_.push_back(event);
  }

  static void onScroll(GLFWwindow* window, double x, double y) {
    WindowEvent event;
    event.kind = Kind::kScroll;
    event.at = glm::vec2(x, y);
    of(window).events_.push_back(event);
  }

  static void onFocus(GLFWwindow* window, int focused) {
    WindowEvent event;
    event.kind = focused != 0 ? Kind::kRedraw : Kind::kFocusLost;
    of(window).events_.push_back(event);
  }

  static void onRedraw(GLFWwindow* window) { of(window).events_.emplace_back(); }
  static void onSize(GLFWwindow* window, int, int) { of(window).events_.emplace_back(); }
};

GlfwWindow::GlfwWindow(const WindowOptions& options) {
  chooseDriverThreads(options.threads);
  if (glfwInit() != GLFW_TRUE) failWithoutWindow();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  // We draw into framebuffers of our own.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwWindowHintString(GLFW_X11_CLASS_NAME, "enfilade");
  window_ =
      glfwCreateWindow(options.size.x, options.size.y, options.title.c_str(), nullptr, nullptr);
  try {
    if (window_ == nullptr) failWithoutWindow();
    makeCurrent();
    gl_ = loadGlFunctions(&glfwGetProcAddress);
  } catch (...) {
    letGoIfCurrent();
    glfwTerminate();
    throw;
  }
  glfwSwapInterval(1);
  listen();
  setFullScreen(options.full_screen);
}

GlfwWindow::~GlfwWindow() {
  letGoIfCurrent();
  glfwDestroyWindow(window_);
  glfwTerminate();
}

void GlfwWindow::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwGetCursorPos(window_, &pointer_.x, &pointer_.y);
  glfwSetKeyCallback(window_, &Callbacks::onKey);
  glfwSetCharCallback(window_, &Callbacks::onText);
  glfwSetCursorPosCallback(window_, &Callbacks::onPointer);
  glfwSetMouseButtonCallback(window_, &Callbacks::onButton);
  glfwSetScrollCallback(window_, &Callbacks::onScroll);
  glfwSetWindowFocusCallback(window_, &Callbacks::onFocus);
  glfwSetWindowRefreshCallback(window_, &Callbacks::onRedraw);
  glfwSetFramebufferSizeCallback(window_, &Callbacks::onSize);
}

void GlfwWindow::take() { glfwMakeContextCurrent(window_); }

void GlfwWindow::letGo() noexcept { glfwMakeContextCurrent(nullptr); }

std::string GlfwWindow::description() const { return describeDriver(gl_); }

glm::ivec2 GlfwWindow::size() const {
  glm::ivec2 size(0);
  glfwGetFramebufferSize(window_, &size.x, &size.y);
  return size;
}

glm::ivec2 GlfwWindow::placeSize() const {
  glm::ivec2 size(place_.z, place_.w);
  if (!fullScreen()) glfwGetWindowSize(window_, &size.x, &size.y);
  return size;
}

float GlfwWindow::contentScale() const {
  glm::vec2 scale(1);
  glfwGetWindowContentScale(window_, &scale.x, &scale.y);
  return scale.y > 0 ? scale.y : 1.0f;
}

bool GlfwWindow::shouldClose() const { return glfwWindowShouldClose(window_) != 0; }
void GlfwWindow::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }
bool GlfwWindow::fullScreen() const { return glfwGetWindowMonitor(window_) != nullptr; }

void GlfwWindow::setFullScreen(bool on) {
  if (on == fullScreen()) return;
  if (!on) {
    glfwSetWindowMonitor(window_, nullptr, place_.x, place_.y, place_.z, place_.w, GLFW_DONT_CARE);
    return;
  }
  GLFWmonitor* monitor = glfwGetPrimaryMonitor();
  const GLFWvidmode* mode = monitor != nullptr ? glfwGetVideoMode(monitor) : nullptr;
  if (mode == nullptr) return;  // a display without a screen: the window stays what it is
  glfwGetWindowPos(window_, &place_.x, &place_.y);
  glfwGetWindowSize(window_, &place_.z, &place_.w);
  glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
}

void GlfwWindow::setTitle(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

bool GlfwWindow::holdsPointer() const {
  return glfwGetInputMode(window_, GLFW_CURSOR) == GLFW_CURSOR_DISABLED;
}

void GlfwWindow::holdPointer(bool hold) {
  if (hold == holdsPointer()) return;
  glfwSetInputMode(window_, GLFW_CURSOR, hold ? GLFW_CURSOR_DISABLED : GLFW_CURSOR_NORMAL);
  if (glfwRawMouseMotionSupported() != 0) {
    glfwSetInputMode(window_, GLFW_RAW_MOUSE_MOTION, hold ? GLFW_TRUE : GLFW_FALSE);
  }
  glfwGetCursorPos(window_, &pointer_.x, &pointer_.y);  // it may have jumped
}

std::vector<WindowEvent> GlfwWindow::takeEvents(double wait_seconds) {
  if (wait_seconds > 0 && events_.empty()) {
    glfwWaitEventsTimeout(wait_seconds);
  } else {
    glfwPollEvents();
  }
  return std::exchange(events_, {});
}

void GlfwWindow::wake() { glfwPostEmptyEvent(); }

GamepadState GlfwWindow::gamepad() const {
  for (int id = GLFW_JOYSTICK_1; id <= GLFW_JOYSTICK_LAST; ++id) {
    GLFWgamepadstate raw;
    if (glfwJoystickIsGamepad(id) == 0 || glfwGetGamepadState(id, &raw) == 0) continue;
    const auto pressed = [&](int button) { return raw.buttons[button] == GLFW_PRESS; };
    const auto trigger = [&](int axis) { return 0.5f * (raw.axes[axis] + 1.0f); };
    GamepadState state;
    state.there = true;
    state.left = stick(raw.axes[GLFW_GAMEPAD_AXIS_LEFT_X], raw.axes[GLFW_GAMEPAD_AXIS_LEFT_Y]);
    state.right = stick(raw.axes[GLFW_GAMEPAD_AXIS_RIGHT_X], raw.axes[GLFW_GAMEPAD_AXIS_RIGHT_Y]);
    state.left_trigger = trigger(GLFW_GAMEPAD_AXIS_LEFT_TRIGGER);
    state.right_trigger = trigger(GLFW_GAMEPAD_AXIS_RIGHT_TRIGGER);
    state.a = pressed(GLFW_GAMEPAD_BUTTON_A);
    state.b = pressed(GLFW_GAMEPAD_BUTTON_B);
    state.x = pressed(GLFW_GAMEPAD_BUTTON_X);
    state.y = pressed(GLFW_GAMEPAD_BUTTON_Y);
    state.left_bumper = pressed(GLFW_GAMEPAD_BUTTON_LEFT_BUMPER);
    state.right_bumper = pressed(GLFW_GAMEPAD_BUTTON_RIGHT_BUMPER);
    state.back = pressed(GLFW_GAMEPAD_BUTTON_BACK);
    state.start = pressed(GLFW_GAMEPAD_BUTTON_START);
    return state;
  }
  return {};
}

void GlfwWindow::present() { glfwSwapBuffers(window_); }

}  // namespace enfilade
