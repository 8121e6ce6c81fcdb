// Wang, Bovik, Sheikh & Simoncelli, Image Quality Assessment: From Error Visibility to Structural
// Similarity, 2004, sec. III.
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "app/image_quality.h"

namespace enfilade {

namespace {

constexpr int kTaps = 11;
constexpr double kSigma = 1.5;
constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
constexpr double kC2 = (0.03 * 255) * (0.03 * 255);

/// What a window says of two pictures: means and raw second moments.
struct Moments {
  double a = 0, b = 0, aa = 0, bb = 0, ab = 0;
};

double similarity(const Moments& m) {
  const double var_a = m.aa - m.a * m.a;
  const double var_b = m.bb - m.b * m.b;
  const double covariance = m.ab - m.a * m.b;
  return (2 * m.a * m.b + kC1) * (2 * covariance + kC2) /
         ((m.a * m.a + m.b * m.b + kC1) * (var_a + var_b + kC2));
}

std::array<double, kTaps> gaussian() {
  std::array<double, kTaps> taps{};
  double sum = 0;
  for (int i = 0; i < kTaps; ++i) {
    const double x = i - kTaps / 2;
    sum += taps[static_cast<std::size_t>(i)] = std::exp(-x * x / (2 * kSigma * kSigma));
  }
  for (double& tap : taps) tap /= sum;
  return taps;
}

std::vector<double> luma(const Image& image) {
  std::vector<double> out(image.rgba.size() / 4);
  for (std::size_t i = 0; i < out.size(); ++i) {
    const std::uint8_t* p = &image.rgba[4 * i];
    out[i] = 0.299 * p[0] + 0.587 * p[1] + 0.114 * p[2];
  }
  return out;
}

/// A small picture as one window.
double similarityOfWhole(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.empty()) return 1;
  Moments m;
  const double weight = 1.0 / static_cast<double>(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    m.a += weight * a[i];
    m.b += weight * b[i];
    m.aa += weight * a[i] * a[i];
    m.bb += weight * b[i] * b[i];
    m.ab += weight * a[i] * b[i];
  }
  return similarity(m);
}

/// The five moments of every column, filtered down the rows of one row of windows.
struct ColumnMoments {
  std::vector<double> a, b, aa, bb, ab;

  explicit ColumnMoments(std::size_t width) : a(width), b(width), aa(width), bb(width), ab(width) {}

  void filter(const double* rows_a, const double* rows_b, const std::array<double, kTaps>& taps) {
    const std::size_t width = a.size();
    for (auto* moment : {&a, &b, &aa, &bb, &ab}) std::fill(moment->begin(), moment->end(), 0.0);
    for (std::size_t k = 0; k < kTaps; ++k) {
      const double* row_a = rows_a + k * width;
      const double* row_b = rows_b + k * width;
      const double tap = taps[k];
      for (std::size_t x = 0; x < width; ++x) {
        const double wa = tap * row_a[x];
        const double wb = tap * row_b[x];
        a[x] += wa;
        b[x] += wb;
        aa[x] += wa * row_a[x];
        bb[x] += wb * row_b[x];
        ab[x] += wa * row_b[x];
      }
    }
  }

  Moments at(std::size_t x, const std::array<double, kTaps>& taps) const {
    Moments m;
    for (std::size_t k = 0; k < kTaps; ++k) {
      m.a += taps[k] * a[x + k];
      m.b += taps[k] * b[x + k];
      m.aa += taps[k] * aa[x + k];
      m.bb += taps[k] * bb[x + k];
      m.ab += taps[k] * ab[x + k];
    }
    return m;
  }
};

}  // namespace

double ssim(const Image& a, const Image& b) {
  assert(a.width == b.width && a.height == b.height);
  const std::vector<double> luma_a = luma(a);
  const std::vector<double> luma_b = luma(b);
  if (a.width < kTaps || a.height < kTaps) return similarityOfWhole(luma_a, luma_b);
  const std::array<double, kTaps> taps = gaussian();
  const auto width = static_cast<std::size_t>(a.width);
  const std::size_t columns = width - kTaps + 1;
  const std::size_t rows = static_cast<std::size_t>(a.height) - kTaps + 1;
  ColumnMoments moments(width);
  double sum = 0;
  for (std::size_t y = 0; y < rows; ++y) {
    moments.filter(&luma_a[y * width], &luma_b[y * width], taps);
    for (std::size_t x = 0; x < columns; ++x) sum += similarity(moments.at(x, taps));
  }
  return sum / static_cast<double>(rows * columns);
}

}  // namespace enfilade
