#include "app/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace enfilade {

namespace {

constexpr double kSecondsBetweenLines = 10.0;
constexpr double kSecondsBetweenBars = 0.1;

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string progressLine(const std::string& stage, double done, double seconds,
                         const std::string& remaining) {
  const std::string share =
      done < 1 ? fmt::format("{:.0f} %", 100 * std::max(done, 0.0)) : std::string();
  return fmt::format("{:<28} {:>5} {:>8.1f} s{}{}", stage, share, seconds,
                     remaining.empty() ? "" : "  ", remaining);
}

std::string remainingText(double done, std::size_t parts, double seconds) {
  std::string text;
  if (parts > 0) {
    text = fmt::format("{:.0f} of {}", done * static_cast<double>(parts), parts);
  }
  if (seconds < 0) return text;
  if (!text.empty()) text += ", ";
  if (seconds < 99.5) return text + fmt::format("{:.0f} s left", seconds);
  return text + fmt::format("{:.0f} min left", seconds / 60);
}

std::string progressBar(double done, int width) {
  const auto full = static_cast<std::size_t>(std::clamp(done, 0.0, 1.0) * width);
  return "[" + std::string(full, '#') + std::string(static_cast<std::size_t>(width) - full, '-') +
         "]";
}

ProgressPrinter::ProgressPrinter(bool quiet)
    : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressPrinter::~ProgressPrinter() {
  if (!stage_.empty() && !quiet_ && terminal_) std::fputs("\r\033[K", stderr);
}

void ProgressPrinter::update(const std::string& stage, double done) {
  if (!stage_.empty() && stage != stage_) endStage();
  const bool starts = stage_.empty();
  if (starts && stage == ended_ && done >= 1) return;
  if (starts) {
    stage_start_ = last_shown_ = Clock::now();
    stage_ = stage;
    first_done_ = 0;
  }
  done_ = done;
  if (first_done_ <= 0 && done > 0) {
    first_done_ = done;
    first_time_ = Clock::now();
  }
  if (done >= 1) {
    endStage();
  } else if (terminal_ && (starts || secondsSince(last_shown_) > kSecondsBetweenBars)) {
    drawBar();
  } else if (!terminal_ && secondsSince(last_shown_) > kSecondsBetweenLines) {
    printLine();
  }
}

void ProgressPrinter::countParts(const std::string& stage, std::size_t parts) {
  parts_stage_ = stage;
  parts_ = parts;
}

ProgressSink ProgressPrinter::sink() {
  return [this](const std::string& stage, double done) { update(stage, done); };
}

void ProgressPrinter::endStage() {
  done_ = 1;
  if (!quiet_ && terminal_) std::fputs("\r\033[K", stderr);
  printLine();
  ended_ = stage_;
  stage_.clear();
}

std::string ProgressPrinter::line() const {
  std::string remaining;
  if (done_ < 1) {
    // Of what this run has done alone: an earlier one may have done the rest.
    const double here = done_ - first_done_;
    const double left = here > 0 ? (1 - done_) / here * secondsSince(first_time_) : -1;
    remaining = remainingText(done_, stage_ == parts_stage_ ? parts_ : 0, left);
  }
  return progressLine(stage_, done_, secondsSince(stage_start_), remaining);
}

void ProgressPrinter::drawBar() {
  last_shown_ = Clock::now();
  if (quiet_) return;
  std::fprintf(stderr, "\r\033[K%s %s", progressBar(done_, 24).c_str(), line().c_str());
  std::fflush(stderr);
}

void ProgressPrinter::printLine() {
  last_shown_ = Clock::now();
  if (quiet_) return;
  std::fprintf(stderr, "%s\n", line().c_str());
}

}  // namespace enfilade
