#include "preprocess/work_crew.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace enfilade {

void shareOutJobs(std::size_t jobs, int threads, const std::function<Worker()>& hire) {
  std::atomic<std::size_t> next{0};
  std::mutex failing;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      if (next >= jobs) return;
      const Worker worker = hire();
      for (std::size_t job = next++; job < jobs; job = next++) worker(job);
    } catch (...) {
      const std::lock_guard lock(failing);
      if (!failure) failure = std::current_exception();
      next = jobs;
    }
  };
  const std::size_t wanted =
      threads > 0 ? static_cast<std::size_t>(threads) : std::thread::hardware_concurrency();
  {
    std::vector<std::jthread> crew;
    for (std::size_t i = 0; i < std::clamp<std::size_t>(wanted, 1, std::max<std::size_t>(jobs, 1));
         ++i) {
      crew.emplace_back(work);
    }
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace enfilade
