#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace enfilade {

/// Ends the program some time after it was asked to stop (see Interruption), if by then it has not
/// come to a place where it looks.  For work that may be killed at any moment.
class StopDeadline {
 public:
  /// `last_words` is called before the end, on a thread of its own.
  StopDeadline(std::chrono::milliseconds patience, std::function<void()> last_words);
  StopDeadline(const StopDeadline&) = delete;
  StopDeadline& operator=(const StopDeadline&) = delete;

 private:
  void watch(const std::stop_token& stop);

  std::chrono::milliseconds patience_;
  std::function<void()> last_words_;
  std::mutex mutex_;
  std::condition_variable_any waiting_;
  std::jthread thread_;  ///< last: it uses all of these
};

}  // namespace enfilade
