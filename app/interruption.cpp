#include "app/interruption.h"

#include <unistd.h>

#include <atomic>

#include "scene/file_io.h"

namespace enfilade {

namespace {

// Set by a signal handler, read by any thread.
std::atomic<int> signal_asked{0};
static_assert(std::atomic<int>::is_always_lock_free);

void remember(int signal) { signal_asked = signal; }

void tidyAndEnd(int signal) {
  removeHalfWrittenFiles();
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// Has `signal` handled unless it is ignored, as by nohup; what it did before goes to `before`.
void handle(int signal, void (*handler)(int), struct sigaction& before) {
  if (sigaction(signal, nullptr, &before) != 0 || before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = static_cast<int>(SA_RESETHAND);  // no SA_RESTART: what blocks comes back
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption() {
  signal_asked = 0;
  for (std::size_t i = 0; i < kSignals.size(); ++i) handle(kSignals[i], &remember, before_[i]);
}

Interruption::~Interruption() {
  for (std::size_t i = 0; i < kSignals.size(); ++i) sigaction(kSignals[i], &before_[i], nullptr);
}

std::optional<Interrupted> Interruption::asked() {
  const int signal = signal_asked;
  return signal == 0 ? std::nullopt : std::optional(Interrupted{signal});
}

void Interruption::throwIfAsked() {
  if (const auto interrupted = asked()) throw Interrupted{*interrupted};
}

void endTidily() {
  for (const int signal : Interruption::kSignals) {
    struct sigaction before {};
    handle(signal, &tidyAndEnd, before);
  }
}

void endBy(const Interrupted& interrupted) {
  std::signal(interrupted.signal, SIG_DFL);
  std::raise(interrupted.signal);
  _exit(128 + interrupted.signal);
}

}  // namespace enfilade
