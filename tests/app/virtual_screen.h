#pragma once

#include <sys/types.h>

#include <memory>
#include <string>
#include <vector>

namespace enfilade {

/// A program that runs beside the test; ended with it.
class BackgroundProcess {
 public:
  /// `output`: a file for what it writes.  `environment`: NAME=VALUE to set.
  BackgroundProcess(const std::vector<std::string>& arguments, const std::string& output,
                    const std::vector<std::string>& environment = {});
  ~BackgroundProcess();
  BackgroundProcess(const BackgroundProcess&) = delete;
  BackgroundProcess& operator=(const BackgroundProcess&) = delete;

  /// Waits up to `seconds` for it to end.  Its exit status, 128 and more: ended by a signal; −1: it
  /// still runs.
  int wait(double seconds);
  bool runs() { return wait(0) == -1; }
  void send(int signal) const;

 private:
  pid_t pid_ = -1;
  int status_ = -1;
};

/// A screen that nobody sees (Xvfb), with keys and a mouse that nobody moves (xdotool).
class VirtualScreen {
 public:
  static bool available();  ///< whether both programs are installed

  /// Starts one of `width` × `height` pixels; its own files go into `folder`.
  VirtualScreen(int width, int height, const std::string& folder);

  const std::string& display() const { return display_; }  ///< ":7"; empty: it did not start

  /// Runs xdotool with `commands`, a line of its own commands.  Whether it succeeded.
  bool act(const std::string& commands) const;

  /// Waits until a window is called `title`, up to `seconds`.
  bool waitForWindow(const std::string& title, double seconds) const;

 private:
  std::string folder_, display_;
  std::unique_ptr<BackgroundProcess> server_;
};

}  // namespace enfilade
