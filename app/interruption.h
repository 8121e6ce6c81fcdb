#pragma once

#include <array>
#include <csignal>
#include <optional>

namespace enfilade {

/// Thrown where work stops because the person, or the system, asked for it.
struct Interrupted {
  int signal = 0;
};

/// While it lives, the signals that end a program do not, but are remembered, so that
/// throwIfAsked() can unwind and what is half written is removed.  The same once more ends it.
/// One at a time.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  /// The one that came, if one did.
  static std::optional<Interrupted> asked();
  /// Throws Interrupted if one came.
  static void throwIfAsked();

 private:
  static constexpr std::array<int, 5> kSignals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU};
  friend void endTidily();

  std::array<struct sigaction, kSignals.size()> before_{};
};

/// From now on the signals that end the program remove what is half written first.
void endTidily();

/// Ends the program as the signal would have.
[[noreturn]] void endBy(const Interrupted& interrupted);

}  // namespace enfilade
