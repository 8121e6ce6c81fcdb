#pragma once

#include <span>

namespace enfilade {

/// The `percent`-th percentile, 0…100: linear between the closest ranks, rank = percent/100 ·
/// (n − 1) over the sorted values (Hyndman & Fan 1996, definition 7; NumPy's default).  0 of none.
double percentile(std::span<const double> values, double percent);

/// What a column of measurements comes to.  All 0 of none.
struct Summary {
  double mean = 0;
  double min = 0, p5 = 0, p50 = 0, p95 = 0, p99 = 0, max = 0;
};

Summary summarise(std::span<const double> values);

}  // namespace enfilade
