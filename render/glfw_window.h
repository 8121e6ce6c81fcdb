#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/gl_context.h"
#include "render/window_events.h"

struct GLFWwindow;

namespace enfilade {

struct WindowOptions {
  std::string title = "Enfilade";
  glm::ivec2 size{1280, 800};  ///< [screen units]
  bool full_screen = false;
  int threads = 0;  ///< of a software driver; 0: as many as the machine has
};

/// A window with an OpenGL 3.3 core context, by GLFW.  One at a time, in the main thread.
class GlfwWindow final : public GlContext {
 public:
  /// Throws Error (kMachine): without a display, saying what needs none, or without OpenGL 3.3.
  explicit GlfwWindow(const WindowOptions& options);
  ~GlfwWindow() override;
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  std::string description() const override;

  glm::ivec2 size() const;       ///< of its framebuffer [pixels]; 0 while it is hidden
  glm::ivec2 placeSize() const;  ///< what WindowOptions::size would have to be; not of full screen
  float contentScale() const;    ///< pixels for what is a pixel on an ordinary screen

  bool shouldClose() const;
  void close();  ///< asks for it, as its frame's button does

  bool fullScreen() const;
  void setFullScreen(bool on);
  void setTitle(const std::string& title);

  /// Whether the pointer is hidden and held, so that it can turn the head without end.
  bool holdsPointer() const;
  void holdPointer(bool hold);

  /// What happened since the last call, in order.  Waits up to `wait_seconds` for the first event
  /// if there is none yet.
  std::vector<WindowEvent> takeEvents(double wait_seconds = 0);

  /// Wakes takeEvents(); from any thread.
  static void wake();

  /// Of the first controller whose buttons are known.
  GamepadState gamepad() const;

  /// Shows what was drawn into the context's own framebuffer.
  void present();

 protected:
  void take() override;
  void letGo() noexcept override;

 private:
  struct Callbacks;
  void listen();

  GLFWwindow* window_ = nullptr;
  std::vector<WindowEvent> events_;
  glm::dvec2 pointer_{0};  // where it was [screen units]
  glm::ivec4 place_{0};    // x, y, width, height outside full screen
};

}  // namespace enfilade
