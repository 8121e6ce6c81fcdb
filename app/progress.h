#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "preprocess/progress.h"

namespace enfilade {

/// Shows progress on stderr: a bar that is drawn over on a terminal, otherwise a line when a stage
/// ends and, for long stages, one every ten seconds, with what remains.  Each stage ends with the
/// time it took.
class ProgressPrinter {
 public:
  explicit ProgressPrinter(bool quiet);
  ~ProgressPrinter();  ///< clears the bar of a stage that did not end
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  void update(const std::string& stage, double done);

  /// From now on `stage` tells its share in parts too: "37 of 84".
  void countParts(const std::string& stage, std::size_t parts);

  /// The printer as a callback; it must outlive it.
  ProgressSink sink();

 private:
  using Clock = std::chrono::steady_clock;
  void endStage();
  std::string line() const;
  void drawBar();
  void printLine();

  bool quiet_;
  bool terminal_;
  std::string stage_;  ///< empty: none is under way
  std::string ended_;  ///< the stage that ended last
  double done_ = 0;
  std::string parts_stage_;  ///< the stage that has parts
  std::size_t parts_ = 0;
  double first_done_ = 0;  ///< the first share told of, perhaps done by an earlier run
  Clock::time_point first_time_;
  Clock::time_point stage_start_;
  Clock::time_point last_shown_;
};

/// The line that stands for a stage: "portal images      30 %      3.1 s  37 of 84, 15 s left".
std::string progressLine(const std::string& stage, double done, double seconds,
                         const std::string& remaining = {});

/// What remains of a stage, `done` of which is done, for its line: "37 of 84, 15 s left".  `parts`
/// 0: it has none; `seconds` < 0: nobody knows how long.
std::string remainingText(double done, std::size_t parts, double seconds);

/// A bar of `width` characters, full when `done` is 1: "[####----]".
std::string progressBar(double done, int width);

}  // namespace enfilade
