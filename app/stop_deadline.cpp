#include "app/stop_deadline.h"

#include "app/interruption.h"

namespace enfilade {

namespace {

constexpr std::chrono::milliseconds kBetweenLooks{50};

}  // namespace

StopDeadline::StopDeadline(std::chrono::milliseconds patience, std::function<void()> last_words)
    : patience_(patience),
      last_words_(std::move(last_words)),
      thread_([this](const std::stop_token& stop) { watch(stop); }) {}

void StopDeadline::watch(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  const auto wait = [&](std::chrono::milliseconds time) {
    waiting_.wait_for(lock, stop, time, [] { return false; });
  };
  while (!stop.stop_requested() && !Interruption::asked()) wait(kBetweenLooks);
  wait(patience_);
  if (stop.stop_requested()) return;
  last_words_();
  endBy(*Interruption::asked());
}

}  // namespace enfilade
