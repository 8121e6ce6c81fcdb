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

std::string progressLine(const std::string& stage, double done, double seconds) {
  const std::string share =
      done < 1 ? fmt::format("{:.0f} %", 100 * std::max(done, 0.0)) : std::string();
  return fmt::format("{:<28} {:>5} {:>8.1f} s", stage, share, seconds);
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
  }
  done_ = done;
  if (done >= 1) {
    endStage();
  } else if (terminal_ && (starts || secondsSince(last_shown_) > kSecondsBetweenBars)) {
    drawBar();
  } else if (!terminal_ && secondsSince(last_shown_) > kSecondsBetweenLines) {
    printLine();
  }
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

void ProgressPrinter::drawBar() {
  last_shown_ = Clock::now();
  if (quiet_) return;
  std::fprintf(stderr, "\r\033[K%s %s", progressBar(done_, 24).c_str(),
               progressLine(stage_, done_, secondsSince(stage_start_)).c_str());
  std::fflush(stderr);
}

void ProgressPrinter::printLine() {
  last_shown_ = Clock::now();
  if (quiet_) return;
  std::fprintf(stderr, "%s\n", progressLine(stage_, done_, secondsSince(stage_start_)).c_str());
}

}  // namespace enfilade
