#pragma once

#include <optional>

namespace enfilade {

/// Thrown where work stops because the person, or the system, asked for it.
struct Interrupted {
  int signal = 0;
};

/// While it lives, SIGINT, SIGTERM and SIGHUP do not end the program but are remembered, so that
/// throwIfAsked() can unwind and what is half written is removed.  The second one ends it.
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
};

/// Ends the program as the signal would have.
[[noreturn]] void endBy(const Interrupted& interrupted);

}  // namespace enfilade
