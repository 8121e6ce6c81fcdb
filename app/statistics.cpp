#include "app/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace enfilade {

namespace {

double percentileOfSorted(std::span<const double> sorted, double percent) {
  if (sorted.empty()) return 0;
  const double rank =
      std::clamp(percent, 0.0, 100.0) / 100.0 * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return std::lerp(sorted[below], sorted[above], rank - static_cast<double>(below));
}

}  // namespace

double percentile(std::span<const double> values, double percent) {
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  return percentileOfSorted(sorted, percent);
}

Summary summarise(std::span<const double> values) {
  if (values.empty()) return {};
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  Summary summary;
  summary.mean =
      std::accumulate(sorted.begin(), sorted.end(), 0.0) / static_cast<double>(sorted.size());
  summary.min = sorted.front();
  summary.p5 = percentileOfSorted(sorted, 5);
  summary.p50 = percentileOfSorted(sorted, 50);
  summary.p95 = percentileOfSorted(sorted, 95);
  summary.p99 = percentileOfSorted(sorted, 99);
  summary.max = sorted.back();
  return summary;
}

}  // namespace enfilade
