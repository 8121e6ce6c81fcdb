#pragma once

#include <chrono>
#include <string>

#include "preprocess/progress.h"

namespace enfilade {

/// Shows progress on stderr: a bar that is drawn over on a terminal, otherwise a line when a stage
/// ends and, for long stages, one every ten seconds.  Each stage ends with the time it took.
class ProgressPrinter {
 public:
  explicit ProgressPrinter(bool quiet);
  ~ProgressPrinter();  ///< clears the bar of a stage that did not end
  ProgressPrinter(const ProgressPrinter&) = delete;
  ProgressPrinter& operator=(const ProgressPrinter&) = delete;

  void update(const std::string& stage, double done);

  /// The printer as a callback; it must outlive it.
  ProgressSink sink();

 private:
  using Clock = std::chrono::steady_clock;
  void endStage();
  void drawBar();
  void printLine();

  bool quiet_;
  bool terminal_;
  std::string stage_;  ///< empty: none is under way
  std::string ended_;  ///< the stage that ended last
  double done_ = 0;
  Clock::time_point stage_start_;
  Clock::time_point last_shown_;
};

/// The line that stands for a stage: "portal images      30 %      3.1 s".
std::string progressLine(const std::string& stage, double done, double seconds);

/// A bar of `width` characters, full when `done` is 1: "[####----]".
std::string progressBar(double done, int width);

}  // namespace enfilade
