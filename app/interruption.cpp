#include "app/interruption.h"

#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>

namespace enfilade {

namespace {

constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};

// Set by a signal handler, read by any thread.
std::atomic<int> signal_asked{0};
static_assert(std::atomic<int>::is_always_lock_free);

void remember(int signal) { signal_asked = signal; }

}  // namespace

Interruption::Interruption() {
  signal_asked = 0;
  for (const int signal : kSignals) {
    struct sigaction action {};
    // What is ignored, as by nohup, stays so.
    if (sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = &remember;
    action.sa_flags = static_cast<int>(SA_RESETHAND);  // no SA_RESTART: what blocks comes back
    sigaction(signal, &action, nullptr);
  }
}

Interruption::~Interruption() {
  for (const int signal : kSignals) {
    struct sigaction action {};
    const bool ours = sigaction(signal, nullptr, &action) == 0 && action.sa_handler == &remember;
    if (ours) std::signal(signal, SIG_DFL);
  }
}

std::optional<Interrupted> Interruption::asked() {
  const int signal = signal_asked;
  return signal == 0 ? std::nullopt : std::optional(Interrupted{signal});
}

void Interruption::throwIfAsked() {
  if (const auto interrupted = asked()) throw Interrupted{*interrupted};
}

void endBy(const Interrupted& interrupted) {
  std::signal(interrupted.signal, SIG_DFL);
  std::raise(interrupted.signal);
  _exit(128 + interrupted.signal);
}

}  // namespace enfilade
