#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <system_error>
#include <thread>
#include <vector>

namespace enfilade {

/// Calls body(i) once for each i < count, on the calling thread and up to `threads` − 1 more, which
/// end before it returns.  `body` must not throw, and must not depend on who runs it or when.
template <typename Body>
void shareOut(std::size_t count, int threads, const Body& body) {
  std::atomic<std::size_t> next{0};
  const auto work = [&]() noexcept {
    for (std::size_t i = next++; i < count; i = next++) body(i);
  };
  const std::size_t most = std::min(count, static_cast<std::size_t>(std::max(threads, 1)));
  std::vector<std::jthread> helpers;
  helpers.reserve(most);
  try {
    while (helpers.size() + 1 < most) helpers.emplace_back(work);
  } catch (const std::system_error&) {
    // The machine has no more threads: those there are do the work.
  }
  work();
}

}  // namespace enfilade
