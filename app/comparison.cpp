#include "app/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "app/statistics.h"

namespace enfilade {

namespace {

constexpr std::uint64_t kSeed = 1998;
constexpr std::size_t kMostResamples = 1000, kLeastResamples = 100;
constexpr std::size_t kMostDraws = 20'000'000;  // in all, so that a long walk takes a second

/// The median as statistics.h has it; reorders `values`, at least one.
double medianOf(std::vector<double>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return std::midpoint(*middle, *std::min_element(middle + 1, values.end()));
}

double medianOf(const RecordedMethod& method) {
  return percentile(method.values("frametime_ms"), 50);
}

/// Whether frame f of both stands at the same place, as far as is known.
bool sameWalk(const RecordedRun& a, const RecordedRun& b) {
  const bool known = !a.tour_sha256.empty() && !b.tour_sha256.empty();
  return known ? a.tour_sha256 == b.tour_sha256 : a.frame_count == b.frame_count;
}

MethodChange changeOf(const RecordedRun& before, const RecordedRun& after,
                      const std::string& name) {
  const RecordedMethod* a = before.method(name);
  const RecordedMethod* b = after.method(name);
  MethodChange change;
  if (a == nullptr || b == nullptr) return change;
  change.of_medians = medianOf(*b) / medianOf(*a);
  if (sameWalk(before, after)) change.paired = pairedRatio(*a, *b);
  return change;
}

/// Says what run `i` has otherwise than the first.
void noteDifferences(const Comparison& of, std::size_t i, std::vector<std::string>& incomparable,
                     std::vector<std::string>& differences) {
  const std::vector<RunFact>& ours = of.runs[i].facts;
  for (const RunFact& first : of.runs.front().facts) {
    const auto same = std::find_if(ours.begin(), ours.end(),
                                   [&](const RunFact& fact) { return fact.what == first.what; });
    if (same == ours.end() || first.identity.empty() || same->identity.empty()) continue;
    if (same->identity == first.identity) continue;
    const std::string values = same->value == first.value
                                   ? fmt::format("two that are both called {}", first.value)
                                   : fmt::format("{} and {}", first.value, same->value);
    (first.must_agree ? incomparable : differences)
        .push_back(fmt::format("A and {} differ in {}: {}", letterOf(i), first.what, values));
  }
}

/// Gives runs of one name their whole path for a name.
void tellNamesApart(std::vector<RecordedRun>& runs) {
  std::multiset<std::string> names;
  for (const RecordedRun& run : runs) names.insert(run.name);
  for (RecordedRun& run : runs) {
    if (names.count(run.name) > 1) run.name = run.folder;
  }
}

std::vector<std::string> methodsOf(const std::vector<RecordedRun>& runs) {
  std::vector<std::string> names;
  for (const RecordedRun& run : runs) {
    for (const RecordedMethod& method : run.methods) {
      if (std::find(names.begin(), names.end(), method.name) == names.end()) {
        names.push_back(method.name);
      }
    }
  }
  return names;
}

}  // namespace

std::optional<PairedRatio> pairedRatio(const RecordedMethod& before, const RecordedMethod& after) {
  const auto& a = before.columns.at("frametime_ms");
  const auto& b = after.columns.at("frametime_ms");
  std::vector<double> ratios;
  for (std::size_t i = 0, j = 0; i < before.frames.size() && j < after.frames.size();) {
    if (before.frames[i] == after.frames[j]) ratios.push_back(*b[j] / *a[i]);
    const std::size_t frame = before.frames[i];
    if (frame <= after.frames[j]) ++i;
    if (after.frames[j] <= frame) ++j;
  }
  if (ratios.empty()) return std::nullopt;
  PairedRatio ratio;
  ratio.frames = ratios.size();
  ratio.median = percentile(ratios, 50);
  ratio.p5 = percentile(ratios, 5);
  ratio.p95 = percentile(ratios, 95);
  std::tie(ratio.least, ratio.greatest) = medianInterval(ratios);
  return ratio;
}

std::pair<double, double> medianInterval(std::span<const double> values) {
  const std::size_t n = values.size();
  if (n == 0) return {0, 0};
  const auto block = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(n))));
  std::mt19937_64 random(kSeed);
  std::vector<double> medians, resample;
  const std::size_t resamples = std::clamp(kMostDraws / n, kLeastResamples, kMostResamples);
  for (std::size_t r = 0; r < resamples; ++r) {
    resample.clear();
    while (resample.size() < n) {
      const std::size_t start = random() % n;
      for (std::size_t k = 0; k < block && resample.size() < n; ++k) {
        resample.push_back(values[(start + k) % n]);
      }
    }
    medians.push_back(medianOf(resample));
  }
  return {percentile(medians, 2.5), percentile(medians, 97.5)};
}

Comparison compareRuns(std::vector<RecordedRun> runs) {
  Comparison comparison;
  comparison.runs = std::move(runs);
  tellNamesApart(comparison.runs);
  for (std::size_t i = 1; i < comparison.runs.size(); ++i) {
    noteDifferences(comparison, i, comparison.incomparable, comparison.differences);
  }
  for (const std::string& name : methodsOf(comparison.runs)) {
    MethodComparison method{name, {}};
    for (std::size_t i = 1; i < comparison.runs.size(); ++i) {
      method.changes.push_back(changeOf(comparison.runs[0], comparison.runs[i], name));
    }
    comparison.methods.push_back(std::move(method));
  }
  return comparison;
}

std::string letterOf(std::size_t run) { return std::string(1, static_cast<char>('A' + run)); }

const char* verdictOf(const PairedRatio& ratio) {
  if (ratio.greatest < 1) return "faster";
  if (ratio.least > 1) return "slower";
  return "no difference";
}

}  // namespace enfilade
