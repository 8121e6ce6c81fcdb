#include "preprocess/work_crew.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

namespace enfilade {
namespace {

TEST(WorkCrew, DoesEveryJobOnce) {
  for (const int threads : {0, 1, 3, 50}) {
    std::vector<std::atomic<int>> done(20);
    shareOutJobs(done.size(), threads, [&] { return [&](std::size_t job) { ++done[job]; }; });
    for (const auto& times : done) EXPECT_EQ(times, 1) << threads;
  }
}

TEST(WorkCrew, HasEachWorkerOnTheThreadThatHiredIt) {
  std::atomic<int> hired{0}, elsewhere{0};
  shareOutJobs(100, 4, [&] {
    ++hired;
    return [&, home = std::this_thread::get_id()](std::size_t) {
      elsewhere += std::this_thread::get_id() != home;
    };
  });
  EXPECT_EQ(elsewhere, 0);
  EXPECT_GE(hired, 1);
  EXPECT_LE(hired, 4);
}

TEST(WorkCrew, HiresNobodyForNothing) {
  shareOutJobs(0, 4, []() -> Worker { throw std::logic_error("hired"); });
}

TEST(WorkCrew, StopsAtAnExceptionAndPassesItOn) {
  std::atomic<int> done{0};
  const auto work = [&] {
    shareOutJobs(1000, 2, [&] {
      return [&](std::size_t job) {
        if (job == 3) throw std::runtime_error("job 3");
        ++done;
      };
    });
  };
  EXPECT_THROW(work(), std::runtime_error);
  EXPECT_LT(done, 1000);
  EXPECT_THROW(shareOutJobs(2, 2, []() -> Worker { throw std::runtime_error("no context"); }),
               std::runtime_error);
}

}  // namespace
}  // namespace enfilade
