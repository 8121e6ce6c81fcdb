#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace enfilade {

/// Threads that stand by, so that even a millisecond's work is worth sharing out, frame after
/// frame. Its own, not a library's: the thread sanitizer sees how they wait for each other.
class ThreadTeam {
 public:
  /// `threads`: the caller of run() among them; 0: as many as the machine has.  If the machine has
  /// no more, those there are do the work.
  explicit ThreadTeam(int threads = 0);
  ~ThreadTeam();
  ThreadTeam(const ThreadTeam&) = delete;
  ThreadTeam& operator=(const ThreadTeam&) = delete;

  int size() const noexcept { return static_cast<int>(helpers_.size()) + 1; }

  /// Calls body(i) once for each i < count and returns when all are done.  `body` must not throw,
  /// and must not depend on who runs it or when.  Called while the team is at work, from a body or
  /// another thread, it does all on the calling thread.  Never allocates.
  template <class Body>
  void run(std::size_t count, const Body& body) noexcept {
    share(
        count, [](const void* of, std::size_t i) noexcept { (*static_cast<const Body*>(of))(i); },
        &body);
  }

 private:
  using Call = void (*)(const void* body, std::size_t i) noexcept;

  void share(std::size_t count, Call call, const void* body) noexcept;
  void workOff() noexcept;
  void help() noexcept;

  // The work at hand; written before `round_` grows, read after.
  Call call_ = nullptr;
  const void* body_ = nullptr;
  std::size_t count_ = 0;

  std::atomic<std::size_t> next_{0};
  std::atomic<std::uint32_t> round_{0};    ///< of work; helpers wait for the next
  std::atomic<std::uint32_t> helping_{0};  ///< helpers that have not ended this round
  std::atomic<bool> busy_{false}, ended_{false};
  std::vector<std::jthread> helpers_;
};

}  // namespace enfilade
