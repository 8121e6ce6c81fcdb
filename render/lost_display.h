#pragma once

#include <functional>

namespace enfilade {

/// What is to be done when the X server goes away, while this lives.  Xlib then ends the program,
/// by the exit status of a wrong command line: instead it is ended by that of a machine that
/// cannot. Of several the latest counts.  Without Xlib, as under Wayland, they are never called.
class LastWords {
 public:
  /// `words` must not touch the window.
  explicit LastWords(std::function<void()> words);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

 private:
  std::function<void()> before_;
};

}  // namespace enfilade
