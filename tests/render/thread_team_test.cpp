#include "render/thread_team.h"

#include <gtest/gtest.h>

#include <numeric>

namespace enfilade {
namespace {

TEST(ThreadTeam, DoesEveryPartOnceRoundAfterRound) {
  for (const int threads : {1, 2, 5}) {
    ThreadTeam team(threads);
    EXPECT_EQ(team.size(), threads);
    for (std::size_t count = 0; count < 200; ++count) {
      std::vector<int> done(count, 0);  // not atomic: each part has its own
      team.run(count, [&](std::size_t i) { ++done[i]; });
      EXPECT_EQ(std::accumulate(done.begin(), done.end(), 0), static_cast<int>(count));
      EXPECT_TRUE(count == 0 || *std::min_element(done.begin(), done.end()) == 1);
    }
  }
}

TEST(ThreadTeam, IsSharedOutOverItsThreads) {
  ThreadTeam team(2);
  std::atomic<int> met{0};
  team.run(2, [&](std::size_t) {  // each waits for the other, so that one thread alone would hang
    ++met;
    while (met < 2) std::this_thread::yield();
  });
  EXPECT_EQ(met, 2);
}

TEST(ThreadTeam, DoesWorkThatComesUpWhileItIsAtWork) {
  ThreadTeam team(3);
  std::vector<std::vector<int>> done(20, std::vector<int>(30, 0));
  team.run(done.size(),
           [&](std::size_t i) { team.run(done[i].size(), [&](std::size_t k) { ++done[i][k]; }); });
  for (const auto& row : done) EXPECT_EQ(row, std::vector<int>(30, 1));
}

TEST(ThreadTeam, TakesAsManyThreadsAsTheMachineHas) {
  EXPECT_EQ(ThreadTeam().size(),
            std::max(1, static_cast<int>(std::thread::hardware_concurrency())));
}

}  // namespace
}  // namespace enfilade
