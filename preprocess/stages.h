#pragma once

#include <chrono>
#include <string>
#include <type_traits>
#include <vector>

#include "preprocess/preprocess.h"
#include "preprocess/progress.h"

namespace enfilade {

/// Times the stages of preprocessing and tells of their progress.
class Stages {
 public:
  Stages(const ProgressSink& sink, std::vector<StageTime>& times) : sink_(sink), times_(times) {}

  template <class Work>
  auto run(const std::string& stage, Work&& work) const {
    const auto start = std::chrono::steady_clock::now();
    tell(stage, 0);
    const auto note = [&] {
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
      times_.push_back({stage, taken.count()});
      tell(stage, 1);
    };
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      note();
    } else {
      auto result = work();
      note();
      return result;
    }
  }

  void tell(const std::string& stage, double done) const {
    if (sink_) sink_(stage, done);
  }

 private:
  const ProgressSink& sink_;
  std::vector<StageTime>& times_;
};

}  // namespace enfilade
