#include "render/thread_team.h"

#include <algorithm>
#include <system_error>

namespace enfilade {
namespace {

/// Waits until `value` is no longer `old`: awake for as long as it takes to wake a thread up, since
/// rounds of work follow each other closely.
void waitWhile(const std::atomic<std::uint32_t>& value, std::uint32_t old) noexcept {
  constexpr int kGlances = 4000;  // some 50 µs
  for (int i = 0; i < kGlances; ++i) {
    if (value.load() != old) return;
#if defined(__x86_64__)
    __builtin_ia32_pause();
#endif
  }
  value.wait(old);
}

}  // namespace

ThreadTeam::ThreadTeam(int threads) {
  const int wanted = threads > 0 ? threads : static_cast<int>(std::thread::hardware_concurrency());
  helpers_.reserve(static_cast<std::size_t>(std::max(wanted, 1)));
  try {
    while (size() < wanted) helpers_.emplace_back([this] { help(); });
  } catch (const std::system_error&) {
    // Those there are do the work.
  }
}

ThreadTeam::~ThreadTeam() {
  ended_ = true;
  ++round_;
  round_.notify_all();
}

void ThreadTeam::share(std::size_t count, Call call, const void* body) noexcept {
  if (count < 2 || helpers_.empty() || busy_.exchange(true)) {
    for (std::size_t i = 0; i < count; ++i) call(body, i);
    return;
  }
  call_ = call;
  body_ = body;
  count_ = count;
  next_ = 0;
  helping_ = static_cast<std::uint32_t>(helpers_.size());
  ++round_;
  round_.notify_all();
  workOff();
  for (std::uint32_t still = helping_; still > 0; still = helping_) waitWhile(helping_, still);
  busy_ = false;
}

void ThreadTeam::workOff() noexcept {
  for (std::size_t i = next_++; i < count_; i = next_++) call_(body_, i);
}

void ThreadTeam::help() noexcept {
  for (std::uint32_t round = 0;; ++round) {
    waitWhile(round_, round);
    if (ended_) return;
    workOff();
    if (--helping_ == 0) helping_.notify_one();
  }
}

}  // namespace enfilade
