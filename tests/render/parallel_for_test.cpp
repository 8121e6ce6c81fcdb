#include "render/parallel_for.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "render/allowed_threads.h"

namespace enfilade {
namespace {

TEST(ParallelForOnThreads, CallsEachOnce) {
  std::vector<int> calls(10'000);
  parallelFor(calls.size(), [&](std::size_t i) { ++calls[i]; });
  EXPECT_EQ(calls, std::vector<int>(calls.size(), 1));
  parallelFor(0, [](std::size_t) { FAIL(); });
}

TEST(ParallelForOnThreads, ThrowsWhatABodyThrowsAndBeginsNoMore) {
  constexpr std::size_t kMany = 1'000'000;
  std::atomic<std::size_t> begun{0};
  EXPECT_THROW(parallelFor(kMany,
                           [&](std::size_t) {
                             ++begun;
                             throw std::runtime_error("enough");
                           }),
               std::runtime_error);
  EXPECT_LT(begun, kMany / 2);
}

TEST(ParallelForOnThreads, KeepsToTheThreadsAllowed) {
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
  std::vector<std::thread::id> who(1000);
  parallelFor(who.size(), [&](std::size_t i) { who[i] = std::this_thread::get_id(); });
  EXPECT_EQ(who, std::vector<std::thread::id>(who.size(), std::this_thread::get_id()));
}

TEST(AllowedThreads, AreWhatOneTbbIsAllowed) {
  EXPECT_GE(allowedThreads(), 1);
  const int before = allowedThreads();
  {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(allowedThreads(), 1);
  }
  EXPECT_EQ(allowedThreads(), before);
}

}  // namespace
}  // namespace enfilade
