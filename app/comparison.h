#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/report_reader.h"

namespace enfilade {

/// How the frames of two walks over the same places relate.
struct PairedRatio {
  std::size_t frames = 0;          ///< that both have
  double median = 0;               ///< of the ratios, frame by frame
  double p5 = 0, p95 = 0;          ///< between which 90 % of the frames' ratios lie
  double least = 0, greatest = 0;  ///< 95 % interval of the median, see medianInterval()
};

/// `after` over `before` of the frames that both have.  Empty if there are none.
std::optional<PairedRatio> pairedRatio(const RecordedMethod& before, const RecordedMethod& after);

/// A 95 % interval for the median of a series whose neighbours are alike, by a circular block
/// bootstrap: 1,000 resamples (fewer of more than 20,000 values) of blocks of about √n.  The same
/// every time.
/// Source: Politis & Romano, A Circular Block-Resampling Procedure for Stationary Data, 1992.
std::pair<double, double> medianInterval(std::span<const double> values);

/// One method in a run after the first, against the first.
struct MethodChange {
  std::optional<double> of_medians;   ///< its median frame time over the first's
  std::optional<PairedRatio> paired;  ///< if the walks are the same
};

struct MethodComparison {
  std::string name;
  std::vector<MethodChange> changes;  ///< of every run after the first
};

struct Comparison {
  std::vector<RecordedRun> runs;          ///< "A", "B" …, names all different
  std::vector<std::string> incomparable;  ///< why frame times cannot be compared
  std::vector<std::string> differences;   ///< what else differs, perhaps what is to be judged
  std::vector<MethodComparison> methods;  ///< that any run has
};

/// Sets runs against the first of them.
Comparison compareRuns(std::vector<RecordedRun> runs);

/// "A" of 0, "B" of 1.
std::string letterOf(std::size_t run);

/// "faster", "slower" or "no difference": what the interval allows to say.
const char* verdictOf(const PairedRatio& ratio);

/// For a person, for a program, and as one page that opens offline.
std::string comparisonText(const Comparison& comparison);
std::string comparisonJson(const Comparison& comparison);
std::string comparisonHtml(const Comparison& comparison);

}  // namespace enfilade
