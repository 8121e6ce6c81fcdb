#include "app/window_moments.h"

#include <algorithm>
#include <cmath>

namespace enfilade {

namespace {

constexpr double kSigma = 1.5;

using Taps = std::array<double, kWindowTaps>;

Taps gaussian() {
  Taps taps{};
  double sum = 0;
  constexpr int kMiddle = kWindowTaps / 2;
  for (int i = 0; i <= 2 * kMiddle; ++i) {
    const double x = i - kMiddle;
    sum += taps[static_cast<std::size_t>(i)] = std::exp(-x * x / (2 * kSigma * kSigma));
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

}  // namespace

WindowRow::WindowRow(std::size_t width) {
  for (auto& moment : down_) moment.resize(width);
  for (auto& moment : windows_) moment.resize(width);
}

void WindowRow::filter(const double* a, const double* b, const Columns& windows) {
  static const Taps taps = gaussian();
  const std::size_t width = down_[0].size();
  const Columns pixels{windows.low, windows.high + kWindowTaps - 1};
  for (auto& moment : down_) std::fill(moment.begin(), moment.end(), 0.0);
  for (std::size_t k = 0; k < kWindowTaps; ++k) {
    addRow(a + k * width, b + k * width, taps[k], pixels);
  }
  for (std::size_t m = 0; m < down_.size(); ++m) {
    const double* const down = down_[m].data();
    double* const out = windows_[m].data();
    std::fill(out + windows.low, out + windows.high, 0.0);
    for (std::size_t k = 0; k < kWindowTaps; ++k) {
      for (std::size_t x = windows.low; x < windows.high; ++x) out[x] += taps[k] * down[x + k];
    }
  }
}

void WindowRow::addRow(const double* row_a, const double* row_b, double tap,
                       const Columns& pixels) {
  double* const a = down_[0].data();
  double* const b = down_[1].data();
  double* const aa = down_[2].data();
  double* const bb = down_[3].data();
  double* const ab = down_[4].data();
  for (std::size_t x = pixels.low; x < pixels.high; ++x) {
    const double wa = tap * row_a[x];
    const double wb = tap * row_b[x];
    a[x] += wa;
    b[x] += wb;
    aa[x] += wa * row_a[x];
    bb[x] += wb * row_b[x];
    ab[x] += wa * row_b[x];
  }
}

}  // namespace enfilade
