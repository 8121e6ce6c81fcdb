// Wang, Bovik, Sheikh & Simoncelli, Image Quality Assessment: From Error Visibility to Structural
// Similarity, 2004, sec. III.
#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "app/image_quality.h"
#include "app/window_moments.h"
#include "render/parallel_for.h"

namespace enfilade {

namespace {

constexpr int kTaps = static_cast<int>(kWindowTaps);
constexpr double kC1 = (0.01 * 255) * (0.01 * 255);
constexpr double kC2 = (0.03 * 255) * (0.03 * 255);

double similarity(const Moments& m) {
  const double var_a = m.aa - m.a * m.a;
  const double var_b = m.bb - m.b * m.b;
  const double covariance = m.ab - m.a * m.b;
  return (2 * m.a * m.b + kC1) * (2 * covariance + kC2) /
         ((m.a * m.a + m.b * m.b + kC1) * (var_a + var_b + kC2));
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

/// Sums over a row of windows.
struct RowSums {
  double all = 0, masked = 0;
  std::size_t masked_windows = 0;
};

/// Two pictures' luma and where they differ.
class Comparison {
 public:
  Comparison(const Image& a, const Image& b, std::span<const std::uint8_t> mask)
      : luma_a_(luma(a)),
        luma_b_(luma(b)),
        mask_(mask),
        width_(static_cast<std::size_t>(a.width)),
        columns_(width_ - kTaps + 1),
        rows_(static_cast<std::size_t>(a.height) - kTaps + 1),
        differing_(static_cast<std::size_t>(a.height)) {
    for (std::size_t y = 0; y < differing_.size(); ++y) differing_[y] = differingColumns(y);
  }

  std::size_t rows() const noexcept { return rows_; }
  std::size_t columns() const noexcept { return columns_; }

  /// Of the windows whose first row is y.
  RowSums sumRow(std::size_t y, WindowRow& row) const {
    // A window in which nothing differs has similarity 1 to the last bit.
    const Columns windows = windowsThatDiffer(y);
    RowSums sums;
    sums.all = static_cast<double>(columns_ - (windows.high - windows.low));
    if (windows.low < windows.high) {
      row.filter(&luma_a_[y * width_], &luma_b_[y * width_], windows);
    }
    const std::uint8_t* const mask =
        mask_.empty() ? nullptr : &mask_[(y + kTaps / 2) * width_ + kTaps / 2];
    for (std::size_t x = 0; x < columns_; ++x) {
      const bool masked = mask && mask[x] != 0;
      const bool differs = x >= windows.low && x < windows.high;
      if (!masked && !differs) continue;
      const double value = differs ? similarity(row.at(x)) : 1.0;
      if (differs) sums.all += value;
      if (masked) sums.masked += value;
      sums.masked_windows += masked;
    }
    return sums;
  }

 private:
  Columns differingColumns(std::size_t y) const {
    const double* const a = &luma_a_[y * width_];
    const double* const b = &luma_b_[y * width_];
    Columns columns{0, width_};
    while (columns.low < width_ && a[columns.low] == b[columns.low]) ++columns.low;
    while (columns.high > columns.low && a[columns.high - 1] == b[columns.high - 1]) --columns.high;
    return columns;
  }

  Columns windowsThatDiffer(std::size_t y) const {
    Columns pixels{width_, 0};
    for (std::size_t k = 0; k < kTaps; ++k) {
      const Columns& row = differing_[y + k];
      if (row.low >= row.high) continue;
      pixels = {std::min(pixels.low, row.low), std::max(pixels.high, row.high)};
    }
    if (pixels.low >= pixels.high) return {};
    return {pixels.low - std::min<std::size_t>(pixels.low, kTaps - 1),
            std::min(pixels.high, columns_)};
  }

  std::vector<double> luma_a_, luma_b_;
  std::span<const std::uint8_t> mask_;
  std::size_t width_, columns_, rows_;
  std::vector<Columns> differing_;  ///< one a row of pixels
};

}  // namespace

Similarity similarityOf(const Image& a, const Image& b, std::span<const std::uint8_t> mask) {
  assert(a.width == b.width && a.height == b.height);
  assert(mask.empty() || mask.size() == a.rgba.size() / 4);
  if (a.width < kTaps || a.height < kTaps) {
    const double whole = similarityOfWhole(luma(a), luma(b));
    const bool any = std::any_of(mask.begin(), mask.end(), [](std::uint8_t m) { return m != 0; });
    return {whole, any ? std::optional(whole) : std::nullopt};
  }
  const Comparison comparison(a, b, mask);
  std::vector<RowSums> sums(comparison.rows());
  constexpr std::size_t kRowsTogether = 16;
  parallelFor((sums.size() + kRowsTogether - 1) / kRowsTogether, [&](std::size_t block) {
    WindowRow row(static_cast<std::size_t>(a.width));
    const std::size_t end = std::min(sums.size(), (block + 1) * kRowsTogether);
    for (std::size_t y = block * kRowsTogether; y < end; ++y) sums[y] = comparison.sumRow(y, row);
  });
  // Row after row, so that the threads do not show in the last digit.
  RowSums total;
  for (const RowSums& row : sums) {
    total.all += row.all;
    total.masked += row.masked;
    total.masked_windows += row.masked_windows;
  }
  Similarity result{total.all / static_cast<double>(comparison.rows() * comparison.columns()), {}};
  if (total.masked_windows > 0) {
    result.mean_over_mask = total.masked / static_cast<double>(total.masked_windows);
  }
  return result;
}

double ssim(const Image& a, const Image& b) { return similarityOf(a, b, {}).mean; }

}  // namespace enfilade
