#pragma once

#include <chrono>

namespace enfilade {

/// Wall time in laps.
class Stopwatch {
 public:
  /// Milliseconds since construction or the lap before.
  double lapMs() {
    const Clock::time_point now = Clock::now();
    const double ms = std::chrono::duration<double, std::milli>(now - lap_).count();
    lap_ = now;
    return ms;
  }
  /// Milliseconds since construction.
  double totalMs() const {
    return std::chrono::duration<double, std::milli>(Clock::now() - start_).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
  Clock::time_point lap_ = start_;
};

}  // namespace enfilade
