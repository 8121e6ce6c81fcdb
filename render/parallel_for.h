#pragma once

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "render/allowed_threads.h"
#include "render/share_out.h"

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define ENFILADE_THREAD_SANITIZER 1
#endif
#elif defined(__SANITIZE_THREAD__)
#define ENFILADE_THREAD_SANITIZER 1
#endif

namespace enfilade {

/// Calls body(i) once for each i < count, on as many threads as oneTBB may use, and returns when
/// they are done.  What a body throws keeps those that have not begun from it, and is thrown here.
/// `body` must not depend on who runs it or when.
/// By oneTBB; in builds for the thread sanitizer, which does not see how that library synchronises,
/// by shareOut, so that a race between two bodies is found.
template <typename Body>
void parallelFor(std::size_t count, const Body& body) {
#ifdef ENFILADE_THREAD_SANITIZER
  std::atomic<bool> failed{false};
  std::exception_ptr thrown;
  std::mutex keeping;
  shareOut(count, allowedThreads(), [&](std::size_t i) {
    if (failed) return;
    try {
      body(i);
    } catch (...) {
      const std::lock_guard lock(keeping);
      if (!failed.exchange(true)) thrown = std::current_exception();
    }
  });
  if (thrown) std::rethrow_exception(thrown);
#else
  tbb::parallel_for(std::size_t{0}, count, body);
#endif
}

}  // namespace enfilade
